dynamics-motor-by-data = the motor given by its data
dynamics-no-motion = the scene has no motion of kind "{ $kind }"
dynamics-no-cycle = a steady regime needs a cycle of the input; give `input.cycle`
dynamics-not-repeating = the machine is not periodic over its cycle: the reduced { $what } is { $before } at coordinate { $from } and { $after } at { $to }; make `input.cycle` whole turns and the loads periodic over it
dynamics-inertia = inertia
dynamics-inertia-derivative = inertia's derivative
dynamics-moment = moment
dynamics-over-time = a load is given by a table over time, which does not repeat with the cycle: there is no steady regime
dynamics-steady-only = { $key } needs a motion of kind "steady": give a number
dynamics-no-value = the equation of motion has no value at coordinate { $coordinate }: { $cause }
dynamics-no-inertia = the reduced inertia with flywheel and rotor is { $inertia } at coordinate { $coordinate }: it must be positive; give some link a mass, or a flywheel
dynamics-stalled = the machine comes to rest at coordinate { $coordinate }: nothing drives it past this point; give [drive] a `motor` or a `torque`, a stronger one, or a larger `flywheel`
dynamics-driven-back = load `{ $load }`: on both sides of the `{ $function }` (character { $column } of the formula) the motion is driven back to where it changes, so it would go on along the change, where the formula gives no value; let it change over a range instead of at once, as `max(-1, min(1, x/0.01))` does in place of `sign(x)`
dynamics-held = the speed is held at coordinate { $coordinate } by a jump of a load over speed; join the rows of its table by a steep line, or write `max(-1, min(1, x/0.01))` in place of `sign(x)` in its formula
dynamics-not-linear = the moment of the loads at coordinate { $coordinate } is not linear in the speed between two jumps or kinks, as this method requires
dynamics-no-path = the speed can't be followed at coordinate { $coordinate }: the moments change too steeply
dynamics-no-regime = there is no steady regime: the work per cycle is { $work } and nothing depends on the speed (a cycle begins with { $energy }); use `torque = "balance"`, a motor or a load over speed
dynamics-other-speed = the requested mean speed of { $wanted } can't be met: without a drive the loads alone fix it, at { $found }; give a drive (`torque = "balance"` or a motor), or that speed
dynamics-not-periodic = no steady regime after { $cycles } cycles: the relative change over a cycle still is { $residual }
dynamics-not-tuned = no ratio and flywheel give the requested regime: after { $trials } trials the mean speed misses by { $mean } % and the unevenness by { $unevenness } %; give one of them
dynamics-too-weak = the motor is too weak for every ratio: the mean resistance needs { $needed }, the motor gives at most { $most }
dynamics-off-section = the motor stays on the stable section of its characteristic, { $low } to { $high } rad/s, at no unevenness: at constant speed it turns at { $speed } rad/s; use `ratio = "solve"` or another motor
dynamics-no-motor = the scene has no motor; give [drive] a `motor`, such as "auto"
dynamics-no-load = the loads themselves do { $work } of work per cycle: the machine needs no motor, and there is no power by which to choose one; set `against_motion = true` for what resists, or name a motor
dynamics-rated = motor: { $cause }
dynamics-stopped = stopped on request
dynamics-flywheel-excess-work = J = A/(ω² δ), A with a constant drive, E eq. 10
dynamics-flywheel-less-inertia = the same less other inertia, E eq. 9
dynamics-flywheel-mertsalov = J = range(A - Jv ω²/2)/(ω² δ) less constant inertia
dynamics-flywheel-wittenbauer = tangents of the energy-mass diagram, constant drive
dynamics-flywheel-exact = periodic solution with the drive
dynamics-friction-none = with dry friction no acceleration is possible here: the motion can't go on (Painlevé); lower the coefficients of friction
dynamics-friction-several = with dry friction { $count } accelerations are possible here, from { $least } to { $most }: which one the motion takes is not determined (Painlevé); lower the coefficients of friction
dynamics-friction-no-method = no linked force analyzer can find the accelerations that are possible with dry friction
