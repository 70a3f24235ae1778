analysis-work = work and kinetic energy
    .reason = change of the kinetic energy compared with the work of all moments (Simpson's rule), relative to the greatest energy; limit: twice the error of the quadrature (estimated with half as many points, or from the change of the power where a formula changes), the rounding of coordinate, speed and potential energy, and the tolerance of each step or the error of fixed steps (an error of the speed, which weighs more where the reduced inertia is greater)
analysis-cycle = cycle in time
    .reason = one cycle integrated again in time from the speed of the regime: relative difference of the speed at its end or of its duration, whichever is nearer to its limit; limit: the tolerance of each step (a fraction of the greatest speed, which weighs more where the machine is slow) and the residual of the regime
analysis-wide-quadrature = too few samples: the work is uncertain by more than 10 %
analysis-wide-rounding = the moments are no larger than the effect of the rounding of the coordinate on them
analysis-wide-motion = the error of the motion (a fraction of its greatest speed at each step) amounts to more than a tenth of the energy: the tolerance is too loose, or the reduced inertia grows without limit near a singular position
analysis-energy = energy
    .reason = a hundred times the tolerance of the integration (four times the error of fixed steps), since its errors add up over the motion, and the effect on the potential energy of rounding the coordinate and its own terms; more where the reduced inertia is much greater than where the motion is fastest
analysis-kinetic-and-potential = kinetic and potential
analysis-periodicity = periodicity
    .reason = the cycle closes to within the rounding of its energy
analysis-speed-over-cycle = speed over a cycle
analysis-mean-speed = mean speed
    .reason = the search stops below 1e-10
analysis-of-extremes = (max - min) / mean
analysis-unevenness = unevenness
    .reason = the search stops below 1e-10 of the speed
analysis-unevenness-of-motor = unevenness of the motor
    .reason = the least or the greatest speed of the motor compared with the end of its stable section, as a fraction of the section
analysis-stable-section = stable section of its characteristic
analysis-unfit = force analyzer `{ $method }` does not support this scene: { $reason }
analysis-infinite = the steady regime has no finite speed and acceleration at the coordinate { $coordinate }: the machine has no inertia there, or loads grow without bound; give its links mass and inertia, or a `flywheel`
analysis-stopped = stopped on request
analysis-at-position = position { $number }: { $error }
analysis-equation = case { $case } of D ({ $equation })
analysis-integrator-named = integrator `{ $method }`, { $reason }: { $summary }; { $equation }
analysis-integrator = integrator `{ $method }`, { $reason }
analysis-if-stiff = where an explicit method finds the equation stiff, `{ $method }`
analysis-order-shown = results show them
analysis-order-accelerations = accelerations in the results
analysis-order-inertia = dJ/dq
analysis-order-masses = accelerations of masses
analysis-order-rest = whether the point of a load that acts against the motion is at rest
analysis-order-power = the virtual power of loads and masses
analysis-order-forces = the force analysis
analysis-other-mobility = Chebyshev's formula gives mobility { $counted }, but in the first position the constraints leave { $found }: it is a singular position (links in one line, or parallel guides), or some constraints repeat others there
analysis-positions = { $count ->
        [one] position
       *[other] positions
    } { $numbers }{ $more }
analysis-and-more = {" "}and { $more } more
analysis-lost = the mechanism stands at a change point (determinant of a group below 1e-5): constraints of a group coincide there and its reactions are not determined
analysis-no-reactions = No reactions in { $positions }: { analysis-lost }.
analysis-no-reactions-of-samples = No reactions at { $count ->
        [one] { $count } sample
       *[other] { $count } samples
    } of the motion: { analysis-lost }.
analysis-no-forces = No forces at { $count ->
        [one] { $count } sample
       *[other] { $count } samples
    } of the motion; at the first: { $reason }.
analysis-unrest = The motion does not come to rest for good ({ $why }); it ends at its first turning point, as with `until = "turn"`.
analysis-other-mean-speed = The requested mean speed of { $wanted } is not met: with the given ratio it is { $found }. Power, flywheel and motion are those of the regime found.
analysis-other-mean-speed-by-moment = The requested mean speed of { $wanted } is not met: with the given moment it is { $found }. Power, flywheel and motion are those of the regime found.
analysis-loads-drive = The loads drive the machine: they do { $work } of work per cycle, and { $brakes } with { $power }.
analysis-motor-brakes = the motor has to brake
analysis-drive-brakes = the drive has to brake
analysis-more-failures = { $more } more failures are not listed.
analysis-drive-unused = `[drive]` is not used: the motion is prescribed or absent; take `kind = "steady"` or "transient".
analysis-integrator-unused-steady = Integrator `{ $method }` is not used: the steady regime is found by collocation over the cycle, not by steps in time.
analysis-integrator-unused = Integrator `{ $method }` is not used: the scene asks for no motion from an initial state.
analysis-step-unused = `step` of [motion] is not used: integrator `{ $method }` chooses its steps by the tolerance; methods with a fixed step: { $fixed }.
analysis-load-idle = Load `{ $load }` never acts: its value is zero in every position (a table or formula that is zero over the cycle, or a load against the motion of what always rests).
analysis-before-time-zero = The prescribed motion passes { $count ->
        [one] { $count } position
       *[other] { $count } positions
    } before time 0, which is that of the first position: there the loads over time have their values for negative time.
analysis-never-reached = The prescribed motion never reaches { $count ->
        [one] { $count } position
       *[other] { $count } positions
    }: it turns back before them; there the loads over time have their values for the time of the turning point.
analysis-spring-without-direction = The ends of spring `{ $spring }` meet in { $positions }: it has no direction and gives no force there, though its free length is { $length }; place one end elsewhere.
analysis-change-points = Change points, where two assembly modes meet: { $places }. A real mechanism may go on in either mode there; the smooth continuation is calculated.
analysis-nearly-singular-modes = Nearly singular: { $group } in position { $position } ({ $place }) has the condition number { $condition }; PF1 and reactions lose as many digits as it has, PF2 twice as many. Its modes { $one } and { $other } nearly coincide there: they meet, or arise, close by.
analysis-nearly-singular = Nearly singular: { $group } in position { $position } ({ $place }) has the condition number { $condition }; PF1 and reactions lose as many digits as it has, PF2 twice as many.
analysis-interpolated = In { $positions } the group is singular, its equations have the form 0/0: the motion there is interpolated from both sides.
analysis-place = { $place } ({ $group })
analysis-place-of-several = { $place } ({ $group } and { $more } more)
analysis-barrier = Past { $end }, { $group } can't be assembled ({ $gap }); the motion from the first position ends there.
analysis-misses = it misses by { $gap } or more
analysis-turning-back = { $count ->
        [one] Position { $numbers }
       *[other] Positions { $numbers }
    } can be reached only in reverse.
analysis-other-motion = { $count ->
        [one] Position { $numbers } is a valid position of the mechanism, but the prescribed motion does not reach it.
       *[other] Positions { $numbers } are valid positions of the mechanism, but the prescribed motion does not reach them.
    }
analysis-run = { $first } to { $last }
analysis-poles = Positions become unbounded where the guides are parallel: { $places }. No mechanism can pass from one side to the other; positions on both are calculated.
analysis-residual-group = group { $number }
analysis-residual-equilibrium = equilibrium
analysis-residual-dynamics = dynamics
analysis-residual-global = global
analysis-load-named = { $name } (load)
analysis-speed-jumps = The speed of the input `{ $drive }` jumps at { $times }: results there are those just after it, and the load of the jump is not among them; `shape = "smooth"` has no jumps.
analysis-listed-backwards = The positions are listed from { $from } to { $to }, and the input moves the other way: velocity arrows point against the order of the positions. With `direction = "{ $direction }"` in [input] the motion follows the list.
analysis-arc-never-slides = The arc of `{ $contact }` never slides, so that it has no friction.
analysis-arc-rolls = The arc of `{ $contact }` rolls without sliding in { $positions }: there its friction has the sense that it has just after.
analysis-friction-pushes = The friction of `{ $contact }` acts in the direction of sliding in { $positions }: its sign is as given. With `friction = { "{" } against_sliding = { $friction } { "}" }` the sign is determined.
analysis-jammed = { $error }; a solution exists up to { $factor } times the given coefficients of friction
analysis-jammed-coefficient = { $error }; a solution exists up to { $factor } times the given coefficient of friction, { $coefficient }
analysis-friction-rests = friction of { $pair }: { $link } never moves relative to { $on }, so no friction acts there
analysis-friction-turns = friction of { $pair }: { $link } is at rest relative to { $on } in { $positions }; the friction given there is that just after
analysis-friction-several = friction: there are several solutions in { $positions }; the results are those of the solution reached when the coefficients grow from zero, or, where there is none, of the one with the least balancing load; the JSON has all of them
analysis-friction-continuum = friction: there is a continuum of solutions in { $positions }; the ends of the interval are listed
analysis-friction-not-proved = friction: it is not proved that no other solution exists in { $positions }
analysis-any-way = No point in [assembly] chooses the assembly mode of { $group }: { $point } was put at { $taken }, but could equally be at { $others }. Write roughly where it is under [assembly].
analysis-place-missed = [assembly] has { $point } at { $wanted }; in the assembly mode taken it is at { $found }, { $distance } away.
analysis-link-rests = Link `{ $link }` never moves.
analysis-slide-rests = Nothing ever slides in `{ $slide }`.
analysis-load-without-work = Load `{ $load }` never does work: reactions alone carry it.
analysis-least-norm = Reactions that the passive links leave undetermined are those of least norm (forces, and moments divided by the size of the mechanism).
analysis-open-reactions = Reactions that the passive links leave undetermined are left open; `{ $option }` gives those of least norm.
analysis-driving-loads = Over the cycle the loads drive the mechanism, and the balancing load holds it back: { $loads }. If one of them is a resistance, reverse its direction.
analysis-never-starts = The mechanism rests all the time: the motion begins at rest, and what drives there is not greater than what resists. Give a `speed`, or a load or [drive] that starts it.
analysis-motors-passed-over = Motor { $motor } was chosen; the nearest ones before it were passed over: { $passed }.
