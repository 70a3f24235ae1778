# The working of a position: headings and remarks.
working-position = position { $position }
working-sample = sample { $sample }
working-at-position = position { $position }
working-at-sample = sample { $sample }, time { $time } s
working-title = { $title }: working of { $of }
working-structure = Structure: { $formula }
working-over-time = the working of a position is written for one input whose coordinate is that of the mechanism; this one moves by laws over time: give the coordinate of a position as `from`, and its speed as `[motion] speed`
working-no-position = there is no position { $position }: the scene has positions 0 to { $last }
working-load = { $place }: { $error }

# Conventions.
working-conventions = Conventions and assumptions
working-axes = Axes: x to the right, y up, fixed to the ground. Angles in rad, counter-clockwise positive, from the x axis; those of links lie between -π and π, the tables of the analysis may differ by whole turns.
working-units = Units: m, kg, s, rad, N, N·m.
working-pf = PF0 is the position of a point (x, y) or the angle φ of the x axis of a link; PF1 and PF2 are its first and second derivatives with respect to the input coordinate q, marked ′ and ″. They are not velocities: v = PF1 ω, a = PF2 ω² + PF1 ε with ω = dq/dt, ε = dω/dt.
working-symbols = { $x }, { $y }: point A. { $phi }: link r. { $u }, { $v }: from A to B in the frame of their link. { $l }: length. { $beta }: angle of A-B from the x axis of its link. α, { $tx }, { $ty }: angle and unit vector of a guide, its normal is (-{ $ty }, { $tx }). ψ: angle of a sliding link from its guide.
working-symbols-of-groups = Quantities of one group carry its number: { $d } is the determinant of group 2.
working-order = Positions run from the input link to the last group; forces from the last group back to the input link.
working-digits = Results have { $digits } significant digits. Intermediate values are carried with all digits; each line shows as many digits of its numbers as its result needs, and can be recomputed from the digits shown. A result such as { $zero } is zero except for rounding.
working-atan2 = atan2({ $arguments }) is the angle of the vector (x, y) in its own quadrant.
working-assumptions = Assumptions: plane motion, rigid links, pairs without clearance.
working-symbols-of-reactions = { $rx }, { $ry }: the force that the pair B exerts on link r; on the other link the pair exerts the opposite. { $mr }: the moment of a slide on that link about the point named with it; its force acts at that point, across the guide.
working-symbols-of-loads = { $x }, { $y }: sum of the known forces on link r. { $m }: their moment about A, counter-clockwise positive.
working-inertia = Inertia loads are -m a at the center of mass and -I φ″ (by time); with them each link is in equilibrium.
working-assumptions-of-forces = Assumptions: pairs without friction; weights and inertia at the centers of mass.
working-assumptions-with-friction = Assumptions: dry friction in the pairs for which the scene gives it, none in the others; weights and inertia at the centers of mass.
working-shares = In a joint B of more than two links, { $share } is the share of links s and t alone; the reaction of B on r is the sum of its shares.

# Words in subscripts, as short as possible.
working-balancing = bal
working-by-power = power
working-by-drive = drive
working-of-drive = d
working-of-inertia = in
working-of-resistance = res
working-of-least = min
working-of-greatest = max
working-of-mean = m
working-of-excess = ex
working-of-flywheel = fw
working-travel = travel
working-left = left
working-right = right

# The input link.
working-input = Input link { $link }
working-input-angle = q is the angle of { $link }: φ′ is 1, φ″ is 0
working-input-displacement = q is the displacement along the guide: PF1 is its direction, PF2 is 0
working-coordinate-of-sample = coordinate of the sample
working-first-coordinate = coordinate of position 0
working-whole-travel = travel of all steps, with its sign
working-number-of-position = number of the position
working-number-of-steps = number of steps

# Groups.
working-class = class { $class }
working-class-and-type = class { $class }, type { $number }
working-group = Group { $group }, { $kind } ({ $class }), links { $links }: positions, PF1, PF2
working-displacement = displacement of the slide { $slide }
working-linear-system = This group is solved by its linear system of { $equations } equations: J u′ = b and J u″ = b, two equations for each pair. Its solution is given first; below, both sides of every equation agree with it.
working-pair-agrees = pair { $pair }: both links give the same
working-solution = solution
working-place-in-solution = place in the solution
working-linear-reactions = The reactions solve the equations of equilibrium of the links (J transposed). They are given first; below, for each link, their sum is the opposite of that of the loads.

# Loads.
working-loads = Loads on the links
working-inertia-loads = Inertia loads
working-load-of = { $load }:
working-speed = speed of the input, dq/dt
working-acceleration = its acceleration, dω/dt
working-mass = mass
working-own-inertia = about the center of mass
working-inertia-here = its moment of inertia here, by { $formula }
working-inertia-slope-here = derivative of its moment of inertia with respect to q
working-gravity = gravity
working-direction = direction
working-direction-in-link = direction in the link
working-none-here = none in this position
working-size-here = size in this position
working-on-link-here = on { $link }, in this position
working-spring-of-no-length = a spring of zero length has no direction: no force
working-stiffness = stiffness
working-free-length = free length
working-damping = damping
working-where-the-force-acts = where the force acts
working-radius = radius
working-friction = coefficient of friction

# The equation of motion.
working-reduction = Reduction to the input link
working-reduced-inertia = J: twice the kinetic energy of the links for ω = 1; J′: its derivative with respect to q
working-reduced-moment = Q: power of all loads but that of the drive for ω = 1, link by link
working-equation = Equation of motion
working-driving-moment = moment of the drive at this speed, on the input link
working-inertia-of-drive = inertia of flywheel and rotor, reduced to the input link
working-check-by-drive = Check by the drive
working-what-the-drive-gives = The drive gives the balancing load, and accelerates flywheel and rotor:
working-must-be = This must equal { $quantity } above.

# Reactions.
working-no-balancing = The balancing load does no work in this position: it is not determined.
working-no-reactions = The reactions of this group are not determined: a singular position.
working-reactions = Reactions of group { $group }, { $kind }
working-balancing-load = Balancing load, from powers
working-unit-power = p is the power of a balancing load of 1 for dq = 1; its size makes the sum of powers zero
working-balancing-direction = direction of the balancing force
working-check-by-power = Check by virtual power
working-whole-power = P: power of all loads and inertia loads for dq = 1, link by link; no reaction does work
working-driven = Input: pair { $pair }
working-driven-angle = q is the angle of { $link } minus that of { $on }
working-driven-displacement = q is the displacement of { $link } along the guide on { $on }
working-follows-coordinate = pair { $pair } is driven: its motion is q, with the derivatives 1 and 0
working-input-forces = Input link { $link }: reaction and balancing load
working-moments-about = moments about { $point }:

# The working of a force analyzer.
working-of-analyzer = working of a force analyzer
working-by-method = Forces found { $method }
working-no-method = This method has no solution in this position.
working-method-and-groups = Check: forces found { $method }, against those by the groups
working-differences = What the method gives minus what was found group by group: zero except for rounding.
# The energy form.
working-energy-way = Displacement of the input
working-energy-turns = in turns:
working-energy-works = Works of drive and loads
working-energy-work-is = The work of a load is the integral of its moment on the input over the coordinate: the area under the graph of the moment. A load that resists does negative work.
working-energy-work-of = Work of { $load }:
working-energy-by-quadrature = by quadrature over the motion
working-energy-moment-at = at { $at }
working-energy-sums = Sums of the works of what drives and of what resists; the drive and each load are in one of them with their work over the whole motion, whereas the results count a load as driving wherever it drives:
working-energy-excess = Excess work
working-energy-change = It is the change of the kinetic energy:
working-energy-at-start = kinetic energy at the start
working-energy-of-links = Its parts at the end by link, m·v^2/2 + I·ω^2/2; the rest is of flywheel and rotor:
working-energy-of-link = at the end
working-energy-rest = At the end the machine is at rest: the works take all of the kinetic energy.
working-energy-speed = Speed at the end
working-energy-inertia = reduced inertia at the end, with flywheel and rotor
working-energy-balance = Constant moment of the drive
working-energy-equal-works = Over a cycle the works of the drive and of the loads are equal and opposite:
working-energy-extremes = Least and greatest speed
working-energy-where = They occur where the moments of drive and loads are equal:
working-energy-where-it-varies = They occur where the kinetic energy changes as if the speed stayed the same: with a reduced inertia that varies, not where the moments of drive and loads are equal.
working-energy-between = Between both places the moments do this work:
working-energy-flywheel = Flywheel
working-energy-neglects = It is reduced to the input link and contains the rotor of the motor, if there is one; the inertia of the links is neglected beside it. The results give the exact flywheel, on its own shaft.
working-energy-artobolevsky = Coefficient of dynamic unevenness

## dry friction
working-friction-in-pairs = Friction in the pairs
working-friction-text = The friction depends on the magnitudes of the reactions. First these are found without friction, then with the friction of the step before, and so on; Newton's method completes the iteration. Each step divides the error by about the spectral radius. The friction found is then a load like others: the reactions below are those without the forces and moments of friction in their pairs.
working-friction-block = { $what }: spectral radius { $radius }, below 1: exactly one solution
working-friction-block-not-proved = { $what }: spectral radius { $radius }, not below 1: the iteration may not converge, so all solutions are found algebraically
working-friction-step = step { $step }: { $moduli }
working-friction-newton = solution: { $moduli }
working-friction-modulus = { $name } = { $value }
working-friction-pin = |R| in { $pair } on { $link }
working-friction-normal = |N| in { $pair }
working-friction-end = |N| at end { $end } of { $pair }
working-friction-of = friction in { $pair }, found above
working-friction-along = component of the direction of the guide
working-to-point = (E eqs. 4-6) The same reduced to the point { $point } of the input link, whose velocity is r ω: one force along the velocity, F = Q/r, and the mass at this point, m = J/r².
working-energy-uniform = Uniformly accelerated motion (D eqs. 3.12, 3.13)
working-energy-speed-at-start = speed at the start
working-energy-speed-at-end = speed at the end
working-energy-by-time = (3.12) ω = ε t + { $speed }, from which the time:
working-energy-way-by-time = (3.13) The displacement in this time, from the start on:
working-energy-balance-resists = Constant moment of the resistance
working-friction-reaction = reaction in { $pair }, found above
working-friction-pressing = normal force in { $pair }, found above
working-friction-pressing-ends = |N₁| + |N₂| on both ends of { $pair }, found above
working-brake-lever = ratio of the lever
working-brake-force = force on the lever
