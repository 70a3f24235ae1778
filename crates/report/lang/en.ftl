# Facts: single numbers.
fact-formula = formula of structure
fact-class = class of the mechanism
fact-mobility = mobility { $number }
fact-change-points = change points, where modes meet
fact-end-time = time of the end of the motion
fact-turns = turns of the whole motion
fact-end-speed = speed at the end of the motion
fact-stroke = stroke of { $slide }, dead points
fact-swing = swing of { $slide }, dead points
fact-time-ratio = time ratio of { $slide }
fact-fastest = peak speed of { $slide }
fact-greatest-pf1 = peak PF1 of { $slide }
fact-transmission = least transmission angle (group { $group })
fact-greatest-reaction = max reaction of { $pair } on { $link }
    .short = { $pair } on { $link }
fact-greatest-moment = max moment of { $pair }
    .short = moment of { $pair }
fact-greatest-load-of-drive = max load of the drive { $drive }
fact-greatest-balancing-moment = max balancing moment
fact-greatest-balancing-force = max balancing force
fact-mean-balancing-moment = mean balancing moment
fact-mean-balancing-force = mean balancing force
fact-rms-balancing-moment = RMS balancing moment
fact-rms-balancing-force = RMS balancing force
fact-greatest-power = max power of the balancing load
fact-unlimited = grows without limit towards { $place }
fact-unsure = about { $value }, not resolved (error up to { $error })
fact-crank-condition = crank condition (Grashof) with { $coupler }, { $rocker }
fact-crank-turns = turns fully: { $crank }, at most { $most }
fact-crank-stops = does not turn fully: { $crank }, at most { $most }
fact-long-crank-turns = turns fully: { $crank }, from { $least } to { $most }
fact-long-crank-stops = does not turn fully: { $crank }, from { $least } to { $most }
fact-crank-never = does not turn fully at any length: { $crank }
fact-travel = travel of { $slide } in the calculated positions
fact-solved-positions = positions with a solution
fact-forceless-positions = positions without forces
fact-of-all = { $found } of { $all }
fact-wanted-motion = requested motion
fact-not-found = not found
fact-checks-hold = checks passed
fact-checks-hold-partly = checks passed on the computed part
fact-checks-fail = checks FAILED
fact-mean-speed = mean speed
fact-unevenness = unevenness
fact-dynamic-unevenness = dynamic unevenness
fact-least-speed = least speed
fact-greatest-speed = greatest speed
fact-cycle-time = time of a cycle
fact-excess-work = excess work
fact-mean-resistance = mean resisting moment, reduced to the input
fact-mean-driving = mean driving moment of the loads, reduced to the input
fact-resistance-work = net work absorbed by the loads per cycle
fact-net-driving-work = net work done by the loads per cycle
fact-driving-work = total positive work of drive and loads per cycle
fact-resisting-work = total negative work of drive and loads per cycle
fact-friction-work = work of dry friction over a cycle
fact-kinetic-energy = kinetic energy with flywheel and rotor
fact-driving-moment = driving moment
fact-braking-moment = resisting moment of the drive
    .short = resisting moment
fact-required-power = required power
fact-power-taken = power absorbed by the drive
    .short = power absorbed
fact-motor = motor
fact-motor-given = given by its rated data
fact-catalogue = catalogue
fact-rated-power = rated power of the motor
    .short = rated power
fact-synchronous-speed = synchronous speed of the motor
    .short = synchr. speed
fact-rated-speed = rated speed of the motor
    .short = rated speed
fact-breakdown-ratio = breakdown torque / rated torque
    .short = breakdown / rated torque
fact-rotor = moment of inertia of the rotor
    .short = inertia of the rotor
fact-motor-mass = mass of the motor
fact-motor-length = length of the motor
fact-motor-diameter = diameter of the motor
fact-characteristic = characteristic
fact-rated-torque = rated torque
fact-breakdown-torque = breakdown torque
fact-working-speed = speed on the working section
    .short = working speed
fact-working-torque = torque on the working section
    .short = working torque
fact-rms-torque = root mean square torque
    .short = rms torque
fact-starting-load = greatest torque of the load at rest
fact-starting-torque = starting torque of the motor
fact-gear-ratio = gear ratio
    .short = ratio
fact-flywheel-of = flywheel on the { $shaft }
fact-flywheel-sizes = { $inertia }, { $mass }, D { $diameter }, b { $width }
fact-flywheel = moment of inertia of the flywheel
    .short = flywheel
fact-shaft-inertia = flywheel and rotor, reduced to the input
fact-multiplier = Floquet multiplier of the speed

# The task.
given-gravity = weights of the links
given-force = force at ({ $place }) of { $link }
given-force-at = force at { $point } of { $link }
given-along-ground = at { $angle } to the x axis
given-along-link = at { $angle } to the x axis of the link
given-against-motion = against the velocity of the point
given-against-rotation = against the rotation of the link
given-moment = moment on { $link }
given-brake = brake on { $link }, radius { $radius }, lever ratio { $lever }, coefficient of friction { $friction }; the value is the force on the lever
given-spring = spring and damper between { $one } and { $other }
given-spring-data = { $stiffness }, free length { $length }, damping { $damping }
given-contact = contact force on the arc of { $link }, radius { $radius }, center { $center }, angle of the normal { $angle }, coefficient of friction { $friction }
given-journal = journal of { $link }, radius { $radius }
given-pressed-place = pressed at one place
given-pressed-faces = pressed on both ends: length { $length }, faces { $offset } from the guide line
given-table = table over { $over } ({ $by }; { $unit }): { $rows }
given-over-coordinate = the input coordinate
given-over-time = time
given-over-speed = the input speed
given-stroke = over the fraction of the stroke along { $axis } (0 to 1; { $unit }): forward { $forward }; back { $back }
given-duration = duration of the motion
given-law = input { $drive }
given-uniform = from { $from } at { $rate }
given-law-spline = cubic spline through (s; { $unit }): { $rows }
given-law-lines = straight lines through (s; { $unit }): { $rows }
given-speed = speed of the input link
given-acceleration = acceleration of the input link
given-initial-speed = initial speed of the input link
given-mean-speed = mean of the greatest and the least speed of the input link
given-unevenness = allowed unevenness
given-driving-moment = driving moment on the input link
given-motor = specified motor
given-chosen = to be chosen from the catalogues
given-wanted = to be found
given-ratio = gear ratio
given-efficiency = efficiency of the reducer
given-flywheel = moment of inertia of the flywheel

# Heads of columns.
head-acceleration = Acceleration
head-acts = Where and how it acts
head-after = After
head-after-position = After position
head-against = Relative to
head-allowed = Allowed
head-angle = Angle
head-at = At
head-balanced = F balanced { $number }
head-before = Before
head-bound = Bound
head-catalogue = Catalogue
head-cause = Cause
head-center-x = Center x
head-change = Change
head-check = Check
head-class = Class
head-coordinate = Coordinate
head-count = Count
head-counterweights = Counterweights
head-curvature = Curvature
head-cycle = Cycle
head-dead-points = Dead points
head-deviation = Deviation
head-diameter = Diameter
head-difference = End - start
head-direction = Direction
head-drive = Drive
head-driving-work = Driving work
head-end-speed = Speed at the end
head-event = Event
head-first-turn = First turn
head-flywheel = Flywheel
head-formula = Formula
head-from-exact = From exact
head-from-x = From x
head-gap = Duality gap
head-greatest = Greatest
head-greatest-force = Greatest force
head-greatest-moment = Greatest moment
head-group = Group
head-groups = Groups
head-guide = Guide
head-inertia = Moment of inertia
head-inner = Inner pairs
head-input-load = Input load
head-input-load-cos = Input load, cos
head-input-load-sin = Input load, sin
head-kind = Kind
head-kinetic-energy = Kinetic energy
head-least = Least
head-limit = Limit
head-link = Link
head-link-or-point = Link or point
head-links = Links
head-load = Load
head-loads = Loads
head-machine = Machine
head-mass = Mass
head-mass-radius = Mass x radius
head-mean-load = Mean load
head-mean-speed = Mean speed
head-mean-speeds = Mean speeds, SI
head-meaning = Meaning
head-method = Method
head-motor = Motor
head-number = No.
head-of = Of
head-on = On
head-order = Order
head-outer = Outer pairs
head-inputs = Inputs
head-driven = Driven pairs
head-overlap = Overlap
head-pair = Pair
head-surfaces = Surfaces
head-coefficient = Coefficient
head-pair-on = Pair, on link
head-place = Place
head-point = Point
head-point-x = Point x
head-points = Points
head-position = Position
head-power = Power
head-quantity = Quantity
head-radius = Radius
head-rated-speed = Rated speed
head-ratio = Ratio
head-remark = Remark
head-reserve = Reserve
head-starting-torque = Starting torque
head-starting-load = Load at rest
head-starts = Starts
head-residual = Rel. residual
head-resisting-work = Resisting work
head-friction-work-of-course = Friction work
head-rests-at = Rests at
head-result = Result
head-rim-speed = Rim speed
head-rms-force = RMS force
head-rms-moment = RMS moment
head-shaft = Shaft
head-size = Size
head-slide = Slide
head-slides = Slides
head-sliding = Sliding
head-sort = Type
head-speed = Speed
head-start-speed = Speed at the start
head-stroke = Stroke
head-through-x = Through x
head-tilt = Tilt
head-time = Time
head-time-ratio = Time ratio
head-trial = Trial
head-type = Type
head-unevenness = Unevenness
head-unit = Unit
head-value = Value
head-vector = Vector
head-mode = Mode
head-modes = Modes
head-what = What
head-width = Width

# The report of a calculation.
report-fact = { $what }: { $value }
report-fact-at = at { $place }
report-rows-shown = ... { $shown } of { $all } rows shown; all are in the other forms (`--format`)
report-columns-shown = ... { $shown } of { $all } columns shown; all are in the other forms (`--format`)
report-structure = Structure
report-links = Moving links: { $count } ({ $links }), input link { $input }
report-chebyshev = Mobility by Chebyshev's formula:
report-mobility-by-rank = Mobility by the rank of the constraints in the first position: { $mobility }
report-note = Note: { $note }
report-formula = Formula: { $formula }
report-class = Class of the mechanism: { $class }
report-pairs = Pairs (R: revolute, P: prismatic)
report-turning = R
report-sliding = P
report-multiple-joint = R, multiple joint
report-groups = Assur groups in solving order (mode: the assembly mode in the first position)
report-task = Task
report-task-text = The mechanism is calculated in { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    } of the input link { $link }. Lengths are in millimeters, in the frame of each link.
report-points = Points in the frames of their links
report-slides = Slides: the point of the sliding link, and the guide line in the frame of the link that carries it
report-masses = Masses, centers of mass in the frames of the links, moments of inertia about them
report-massless = All links are massless.
report-given-loads = Loads as they are given
report-given-friction = Friction of the pairs as it is given
report-given-motion = Motion and drive as they are given
report-shown-positions = Shown positions
report-positions-shown = The tables show { $shown } of { $all } positions; greatest values are those of all. All positions are written by `-o FILE.parquet`, `--format csv -o FOLDER` or `--format json`.
report-positions = Positions
report-angles = Angles of the links
report-displacements = Displacements of the slides
report-partials = Transfer functions by the coordinate of each drive, the others at rest
report-by-coordinate = { $what }, by the coordinate of { $drive }
report-drives = Drives
report-loads-of-drives = Loads of the drives
report-loads-of-drives-table = Loads of the drives: moments or forces along the guides
report-load-of-drive = Load of the drive { $drive }: a moment, or a force along the guide
report-transfer = Transfer functions (derivatives with respect to the input coordinate)
report-rates = Velocities and accelerations
report-input = Input
report-links-rates = Angular velocities (ω) and accelerations (ε) of the links
report-points-rates = Velocities and accelerations of the points
report-slides-rates = Relative velocities and accelerations of the slides
report-further = Further quantities
report-condition = Condition of the groups
report-condition-text = 1 / (dimensionless determinant): 1 is the best possible; errors of PF1 grow with it, those of PF2 with its square; infinite at a singular position.
report-group-number = group { $number }
report-motion = Motion
report-no-motion = There is no motion to report: { $reason }
report-equation = Equation of motion: { $equation } (case { $case } of D 3.21)
report-integrator = Integrator: { $method } ({ $reason })
report-integration-cost = Tolerance { $tolerance }; { $steps } steps, { $rejected } rejected or redone, { $evaluations } evaluations, { $jacobians } Jacobians, { $pieces } smooth pieces
report-integration-fixed = Fixed step { $step }; { $steps } intervals, { $evaluations } evaluations, { $jacobians } Jacobians, { $pieces } smooth pieces
report-mean-step = { $step } on average
report-stiffness = Step times largest eigenvalue at the end: { $value }
report-motion-error = Estimated error of the motion, relative to its greatest speed and to its travel: { $value }
report-end = End: { $time }, { $raw } ({ $coordinate }), { $speed }
report-energies = Kinetic energy { $start } at the start, { $end } at the end; potential energy { $potential_start } and { $potential_end }
report-energy-drift = Only weights and springs act; drift of the energy, relative to the largest kinetic energy: { $change }
report-energy-work = Work of the other loads, relative to the largest kinetic energy, at most: { $change }
report-course = Motion over time ({ $shown } of { $all } samples)
report-held = Held at { $speed } from { $time } at the latest; holding load at the input { $held } (limit { $bound })
report-events = Events: jumps, reversals, rest (first { $shown } of { $all })
report-greatest-at-samples = Greatest reactions at the samples
report-regime = Steady regime
report-effort = Found by shooting on collocation of order 15: { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    }, { $panels } panels per cycle, { $evaluations } evaluations of the mechanism; between the nodes the equation of motion holds to within { $residual } of the kinetic energy
report-iteration = Iteration to the periodic regime from the mean speed (S fig. 10)
report-trials = Trials of ratio and flywheel, each with its periodic regime (S stage 6)
report-regime-course = Speed in the regime and in the first turn (S fig. 9), moments and inertia reduced to the input (S fig. 12)
report-drive = Drive and flywheel
report-motor = Motor
report-flywheel-needless = The requested unevenness is achieved without a flywheel.
report-warning = Warning: { $warning }
report-runners-up = Other suitable motors, with the ratio that each would need (first { $shown } of { $all })
report-flywheel-methods = Flywheel by each method (all but the exact one assume a constant driving moment, so their excess work A differs from that above)
report-flywheel-places = The two possible locations of the flywheel (S fig. 13), as a steel disc of width b = 0.1 D: J = π ρ b D⁴/32, m = π ρ b D²/4
report-kept = kept
report-exceeded = EXCEEDED
report-motors-first = The first { $shown } of { $all } motors that have the power and stay within the speed limit
report-motors = Greatest unevenness for which each motor stays on the stable section of its characteristic, with the flywheel for it; reserve: breakdown torque over the greatest torque of the cycle; a motor starts where its starting torque is not below the greatest torque of the load at rest
report-starts = yes
report-starts-not = NO
report-usual = Usual unevenness of machines ({ $source })
report-loads = Loads and inertia loads
report-loads-table = Loads: a force along its direction, a moment counter-clockwise, the tension of a spring
report-inertia-table = Inertia loads: principal vector -m a at the center of mass, principal moment -I ε
report-shaking-table = Shaking force on the ground, and shaking moment about the origin
report-reduction = Reduction to the input link
report-reduced = Inertia J, its derivative dJ/dq, and Q of all loads but the balancing one
report-shares = Shares of the links in J (E eq. 8); flywheel and rotor are not in J
report-reduced-to-point = The same reduced to point { $point } of the input link: force F = Q/r along its motion, mass m = J/r², r = { $radius }
report-reactions = Reactions
report-reactions-text = The force that the pair exerts on the named link (the other link receives the opposite): components, magnitude R, direction from the x axis. Slides: M is the moment on the sliding link about its point; s is where along the guide, from that point, the force alone would do the same.
report-reactions-table = Reactions of the pairs
report-greatest-reactions = Reactions in the calculated positions: greatest, and root mean square
report-balancing-moment = Balancing moment
report-balancing-force = Balancing force
report-balancing-moment-on = The moment on `{ $link }` that maintains the motion of the mechanism
report-balancing-force-on = The force on `{ $link }` that maintains the motion of the mechanism
report-greatest-balancing = Greatest in the calculated positions: { $load } in position { $position } ({ $at })
report-causes = Reactions by cause
report-causes-text = What each cause alone would do in the same position: components and magnitude of the force on the named link. Components sum to those of the whole; magnitudes do not.
report-whole = total
report-balancing = Balancing load
report-sides = Sides of the guides
report-sides-text = Where the force of a guide on its sliding link changes its side.
report-one-side = stays on one side
report-jumps = jumps
report-passes-zero = through zero
report-enveloping = Enveloping by { $contact }
report-enveloping-text = Path of the lowest point of the arc from { $from } to { $to }. The line from which it deviates least lies at y = { $level }; the greatest deviation is { $greatest }, at { $at }; the point travels { $way } along the line. Sliding is the speed of the arc along the line per unit speed of the input; 0 where it rolls.
report-notes = Notes
report-failures = Positions without a solution
report-checks = Checks
report-checked-in = checked in { $checked } of { $of }: { $checks }
report-not-judged-in = not judged in { $count ->
        [one] { $count } position
       *[other] { $count } positions
    }: { $checks }: { $reason }
report-not-judged = not judged: { $check }: { $reason }

# The geometry of the motion.
geometry-strokes = Strokes and dead points
geometry-no-strokes = Nothing reciprocates.
geometry-turns-back = { $slide } turns back at { $places }; without a second dead point in the range it has no stroke.
geometry-extremes = Extremes over the cycle
geometry-modulus = |{ $of }|
geometry-displacement = displacement
geometry-angle = angle
geometry-force-angles = Angles of transmission and pressure
geometry-force-angle = { $group }: { $what } from { $least } (at { $at_least }) to { $most } (at { $at_most })
geometry-force-angle-constant = { $group }: { $what } { $angle }, constant
geometry-rests = Positions of rest
geometry-rests-always = At rest over the whole cycle: { $links }.
geometry-centers = Centers of the links
geometry-centers-text = P: instant center in the frame of the link `{ $link }` (fixed centrode); p: in the frame of the link itself (moving centrode); J: inflection pole, the other end of the diameter of the inflection circle from P; Q: pole of accelerations at constant input speed. A dash: at infinity.
geometry-rigid = Rigid with `{ $against }` over the whole cycle, and so without centers: { $links }.
geometry-curvature = Curvature of the paths of points
geometry-curvature-text = The curvature is positive where the path turns left. A dash: the point rests.

# Shaking force and counterweights.
shaking-least-squares = on { $links }: least squares
shaking-least-maximum = on { $links }: minimax
shaking-sizes = Shaking force and shaking moment on the ground, before and after balancing
shaking-sizes-text = Resultants of the inertia loads of all moving links; moments about the origin. Greatest values are found between positions too; the mean square is over the coordinate.
shaking-no-counterweight = no counterweight
shaking-proof = The minimax problem is convex: its dual proves that no counterweights on these links make the greatest force less than the bound. The gap is the excess of the greatest force over the bound, relative to the bound.
shaking-counterweights = Counterweights
shaking-no-pivot = No link turns about a pin on the ground, so none can carry a counterweight.
shaking-counterweights-text = Only mass times radius matters; the mass is for the radius of the farthest point of the link. The direction is from the pin on the ground, in the frame of the link.
shaking-harmonics = Harmonics without counterweights
shaking-harmonics-text = Factors of cos(k q) and sin(k q); order k makes k periods in a cycle, order 0 is the mean. The input load is what the input needs for the motion under all loads.
shaking-positions = Shaking force over the cycle

# The plans of a position.
plan-with-scale = { $title }: unit { $unit }, 1 mm = { $scale } { $unit }; relative residual { $residual }
plan-without-scale = { $title }: unit { $unit }; relative residual { $residual }
plans-of = Plans of position { $position } ({ $link } { $at })
plan-centers = Instant centers
plan-at-infinity = at infinity, in this direction
plan-no-relative-motion = no relative motion
plan-causes = Reactions by cause; the shares sum to the whole up to { $residual } of the greatest force
plan-balancing = balancing

# The explanatory note.

# Words for keys of the drive and of events.
drive-excess-work = excess work
drive-excess-work-less-inertia = excess work less links
drive-mertsalov = Mertsalov
drive-wittenbauer = Wittenbauer
drive-exact = exact
drive-input-shaft = input shaft
drive-motor-shaft = shaft of the motor
drive-kloss = Kloss's formula
drive-linear = straight line
event-coordinate = bound of a load along the coordinate
event-speed = bound of a load in speed
event-switch = change of a load over several variables
event-time = bound of a load in time
event-reversal = reversal
event-rest = rest
event-held = speed held
event-release = release
event-face = other face

# What is calculated, and how.
explain-stages = Stages
explain-modelled = Modeled
explain-not-modelled = Not modeled
explain-run = { $stage }: run: { $reason }; method: { $method }
explain-left-out = { $stage }: left out: { $reason }
explain-mobility = Mobility by Chebyshev's formula: W = 3*{ $links } - 2*{ $pairs } = { $mobility }
explain-passive = Passive: { $parts }; by count this repeats constraints of other parts, and without it W = 1
explain-not-needed = not needed for what is asked for
explain-carries-nothing = carries no load: its reactions are zero
explain-singular-at = singular at: { $place }
explain-and-more = { $names } and { $count } more
explain-stage-structure = structure
explain-structure = everything else follows from the groups and their order
explain-matching = equations counted and matched to unknowns, strongly connected parts are the groups; mobility by Chebyshev's formula, not by the rank of the constraints, for which all groups would have to be placed
explain-matching-and-rank = equations counted and matched to unknowns, strongly connected parts are the groups; mobility by Chebyshev's formula and by the rank of the constraints (singular values) in the first position
explain-stage-positions = positions (PF0)
explain-positions = { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    } over { $over }; { $needed } of { $groups } groups are needed for what is asked for
explain-not-solved = not solved, nor is it checked whether they can be assembled: { $groups }
explain-input-alone = the input link alone
explain-group-by-group = group by group by the registered kinds ({ $kinds }); the assembly mode is followed by continuity from the first position
explain-angle-of = the angle of `{ $link }`
explain-displacement-of = the displacement of `{ $link }`
explain-stage-transfer = transfer functions (PF1, PF2)
explain-derivatives-input = of the input link, exact
explain-derivatives-constraints = derivatives of the constraints of each group with respect to the input coordinate, not by differences
explain-derivatives-both = derivatives of the closed forms of each group with respect to the input coordinate, of the constraints where a kind iterates, not by differences
explain-derivatives-closed = derivatives of the closed forms of each group with respect to the input coordinate, not by differences
explain-rates = v = PF1 w, a = PF2 w^2 + PF1 e
explain-rates-over-time = derivatives of the closed forms of each group with respect to time, from speeds and accelerations of the drives by their laws
explain-order-0 = orders up to 0: nothing that is asked for needs derivatives; saves PF1 and PF2 of { $groups ->
        [one] { $groups } group
       *[other] { $groups } groups
    }
explain-order-1 = orders up to 1, for: { $what }; nothing needs PF2; saves PF2 of { $groups ->
        [one] { $groups } group
       *[other] { $groups } groups
    }
explain-order-2 = orders up to 2, for: { $what }
explain-stage-velocities = velocities and accelerations
explain-has-motion = the scene has a `[motion]`
explain-add-motion = no motion is given; add `[motion]` with a speed
explain-no-rates-asked = `[output]` asks for no link, point or slide
explain-stage-reduction = reduction to the input link
explain-sums = sums over masses and loads with the transfer functions of their points (S eqs. 1-3)
explain-no-reaction-asked = `[output]` asks for no reaction
explain-nothing-to-reduce = no link has a mass and nothing loads the links
explain-reduced = J, dJ/dq and Q of all moving links and loads make the equation of motion
explain-reduced-without-mass = Q of all loads; no link has a mass: J is zero, and dJ/dq is not computed
explain-reduced-constant = J and Q of all moving links and loads make the equation of motion; J is the same at every coordinate, as { $links } alone has mass and turns or slides with the coordinate, or rests: dJ/dq is exactly zero and not computed
explain-stage-motion = equation of motion
explain-no-motion = no motion is given
explain-prescribed = speed and acceleration are prescribed; `kind = "transient"` or "steady" would find them
explain-given-over-time = the laws of the drives over time give the motion
explain-no-common-coordinate = several drives have no coordinate in common to which masses and loads could be reduced
explain-transient = the motion follows from an initial state
explain-integrator = integrator `{ $method }`
explain-steady = the periodic regime is sought: J w dw/dq + J' w^2/2 = Q + M over one cycle
explain-shooting = shooting: the speed over the cycle by collocation of order 15 between all jumps of the loads, a Newton step on the speed at the start; no integrator in time
explain-stage-drive = drive and flywheel
explain-no-drive = no motor, reducer or flywheel is given; add `[drive]`
explain-drive-useless = `[drive]` has no use where the motion is prescribed or absent
explain-drive-given = the scene has a `[drive]`, all of it given
explain-drive-wanted = the scene has a `[drive]`; to be found: { $what }
explain-wanted-moment = the constant moment that makes the work of a cycle zero
explain-wanted-motor = the motor
explain-wanted-ratio = the gear ratio
explain-wanted-flywheel = the flywheel
explain-least-motor = the least rated power that suffices without exceeding the greatest motor speed (S stage 5)
explain-kloss = torque over speed by Kloss's formula
explain-linear = torque over speed as the straight line through synchronous and rated speed
explain-constant-moment = a constant moment on the input link
explain-no-torque = no torque
explain-newton-search = ratio and flywheel by a Newton search in which every trial has its own periodic regime (S stage 6); beside it the flywheel by E eqs. 9 and 10, Mertsalov and the energy-mass diagram
explain-stage-inertia = inertia loads
explain-inertia = links with mass move at a known speed
explain-dalembert = -m a at the center of mass and -I e (d'Alembert)
explain-static = no motion is given: the force analysis is static
explain-no-mass = no link has a mass
explain-stage-reactions = reactions
explain-loads-act = loads act on the links
explain-links-have-inertia = the links have inertia
explain-reactions-zero = the scene has a `[motion]`, but neither mass nor load: every reaction is zero
explain-analyzer = force analyzer `{ $analyzer }` (`assur plugins` lists others)
explain-no-load = there is neither a load nor a motion; add `gravity`, `[[force]]` or `[motion]`
explain-idle-as-one-system = { $groups }: no load reaches it, but this method solves the mechanism as one system{ $hint }
explain-leaves-out = {" "}(`{ $method }` would leave it out)
explain-idle = { $idle } of { $all } groups not solved, as no load reaches them (no weight, mass in motion, force, moment, spring, contact or balancing load on their links, nor on a group behind them), so that their reactions are exactly zero: { $groups }
explain-stage-balancing = balancing load
explain-with-reactions = it is found together with the reactions
explain-balance-moment = a moment on `{ $link }`, from `[balance]`
explain-balance-force = a force on `{ $link }`, from `[balance]`
explain-time-of = the time; the coordinates of { $link } are functions of it
explain-input-loads = a load of each drive: { $link }
explain-input-moment = a moment on the input link `{ $link }`
explain-input-force = a force on the input link `{ $link }`
explain-equilibrium-of-input = equilibrium of the input link, which comes last
explain-equilibrium-of-driven = equilibrium of the links that are driven, after all reactions are known
explain-stage-checks = checks
explain-checks-need-all = `[output]` leaves groups out; the checks need the whole mechanism (`assur check`)
explain-residuals = the residuals show how far the numbers can be trusted
explain-checks = closure of every pair, derivatives compared with differences, equilibrium of every link, agreement of two analyzers, Lagrange-d'Alembert, virtual power compared with the balancing load

# What is modelled.
model-links = links
model-links-how = { $count ->
        [one] { $count } moving link
       *[other] { $count } moving links
    }, rigid, in one plane
model-pairs = pairs
model-pairs-how = { $pins ->
        [one] { $pins } pin
       *[other] { $pins } pins
    } and { $slides ->
        [one] { $slides } slide
       *[other] { $slides } slides
    }, ideal: no play, no friction
model-pairs-friction = { $pins ->
        [one] { $pins } pin
       *[other] { $pins } pins
    } and { $slides ->
        [one] { $slides } slide
       *[other] { $slides } slides
    }, no play, dry friction as follows
model-friction = friction of { $pair }
model-journal = coefficient { $coefficient }, journal of { $owner } with a radius of { $radius }: a moment against the rotation, proportional to the magnitude of the reaction
model-pressed-place = coefficient { $coefficient }, pressed at one point: a force against the sliding, proportional to the normal force
model-pressed-ends = coefficient { $coefficient }, pressed on both ends of a contact of { $length } about the point of the slider, faces { $offset } from the guide line
model-pressed-bushing = coefficient { $coefficient }, pressed on both ends of a contact of { $length } about the point of the guide (a bushing), faces { $offset } from the guide line
model-masses = masses
model-masses-how = of { $count ->
        [one] { $count } link
       *[other] { $count } links
    }, { $sum } in all, at their centers of mass
model-weights-how = gravity ({ $gravity })
model-motion = motion
model-prescribed = speed and acceleration of the input are prescribed, the same in every position; time counts from the first position and follows from both
model-prescribed-with-inertia = speed and acceleration of the input are prescribed, the same in every position; time counts from the first position and follows from both; inertia loads follow from them
model-laws-over-time = the laws of the drives give coordinates, speeds and accelerations; the time counts from 0; inertia loads follow from them
model-transient = found from the initial state by the equation of motion, from masses and loads
model-steady = the periodic regime: the speed repeats after every cycle; run-up is not considered
model-against-motion = always against the motion of its point
model-against-rotation = always against the rotation of its link
model-turns-with-link = in a direction that turns with the link
model-fixed-direction = in a fixed direction
model-at-point = at a point of `{ $link }`
model-brake = a shoe on the disc of `{ $link }`, its moment always against the rotation, the force on its lever { $law }
model-moment = on `{ $link }`, { $law }
model-spring = between `{ $one }` and `{ $other }`, massless, along the line between its ends, linear, { $damped }
model-undamped = without damping
model-damped = with damping
model-constant = constant
model-over-coordinate = by a table over the input coordinate
model-over-speed = by a table over the input speed, which is counted along the direction of the input
model-over-time = by a table over time
model-formula-speed = by a formula, whose `w` is the input speed along the direction of the input
model-formula = by a formula
model-stroke = by tables over the stroke of the point, forward and back
model-contact = an arc on a straight line of the ground, { $touches }, with the force that is given; { $friction }
model-contact-smooth = without friction (add `friction` to the `[[contact]]`)
model-contact-against-sliding = its friction is a given part of the force, against the sliding of the arc
model-contact-rough = its friction is a given part of the force, in a given sense
model-contact-interval = in its interval
model-contact-always = in every position
model-drive = drive
model-drive-motor = the motor's torque by its steady characteristic over speed, through the gear ratio, at the input shaft
model-drive-balance = a constant torque at the input shaft, which makes the work of a cycle zero
model-drive-constant = a constant torque at the input shaft, along the direction of the input
model-drive-none = no torque: the drive has neither `motor` nor `torque`
model-rotor = of the motor, reduced to the input shaft by the square of the gear ratio
model-rotor-of-chosen = of the motor that is chosen, where its catalogue gives it, reduced to the input shaft by the square of the gear ratio
model-losses = a constant efficiency of the reducer, { $efficiency }, whatever speed and load
model-flywheel = a constant moment of inertia on its shaft

# What is not modelled.
missing-mass = mass of { $links }
missing-mass-how = the scene gives none, so they have neither weight nor inertia loads; add `mass`, `center` and `inertia` to the link
missing-mass-of-rotor = the scene gives none, so they have no weight and no inertia force, only the moment of their `inertia`; add `mass` and `center` to the link
missing-inertia = moment of inertia of { $links }
missing-inertia-how = the scene gives none; add `inertia` (about the center of mass) to the link
missing-inertia-needless = the scene gives none, and none is needed: sliding on the ground, it never turns
missing-weights = weights
missing-weights-mass = there is gravity, but no link has a mass; add `mass` to the links
missing-weights-gravity = the scene gives no gravity (a horizontal mechanism needs none); add `gravity = "9.81 m/s^2"`
missing-weights-both = the scene gives neither gravity nor masses; add `gravity = "9.81 m/s^2"` and `mass` to the links
missing-velocities = velocities and inertia loads
missing-velocities-how = the scene gives no motion; add `[motion]` with a speed
missing-fluctuation = fluctuation of the input speed
missing-fluctuation-how = the motion is prescribed, whatever moment it takes; `kind = "steady"` or "transient" in `[motion]` finds the speed from masses and loads
missing-fluctuation-over-time = the laws of the drives are kept, whatever loads they take; a single input without `over_time` may have `kind = "steady"` or "transient" in `[motion]`, which finds the speed from masses and loads
missing-run-up = run-up and run-down
missing-run-up-how = only the periodic regime is considered; `kind = "transient"` in `[motion]` follows the motion from an initial state
missing-loads = working loads
missing-loads-how = the scene gives none; add `[[force]]`, `[[moment]]`, `[[spring]]` or `[[contact]]`
missing-damping = damping, resistance of air and oil
missing-damping-how = the scene gives none; add a `[[spring]]` with `damping`, or a load over the speed
missing-damping-over-time = the scene gives none; add a `[[spring]]` with `damping`
missing-drive = motor, reducer, rotor inertia, drive losses and flywheel
missing-drive-useless = `[drive]` has no use with a motion that is prescribed or absent; take `kind = "steady"` or "transient"
missing-drive-how = the scene gives no drive; add `[drive]` with `motor` and `flywheel`
missing-drive-prescribed = the input is moved as it is prescribed, by the balancing load; add `[drive]` with `motor` and `flywheel`, and `kind = "steady"` or "transient" to `[motion]`
missing-drive-over-time = the drives move as their laws say, by the loads that are found; only a single input without `over_time` may have `[drive]`
missing-rotor = rotor inertia
missing-rotor-how = the rated data give none; add `inertia` to `motor`
missing-rotor-of-catalogue = the catalogue gives none for this motor; give the motor by its data: `motor = {"{"} power, ..., inertia {"}"}`
missing-rotor-no-motor = the drive has no motor; name one with `motor` in `[drive]`
missing-electrical = electrical transients of the motor
missing-electrical-how = its torque follows the speed at once, by the steady characteristic; they can't be included
missing-reducer = inertia and elasticity of the reducer
missing-reducer-how = the transmission is rigid and massless; add its inertia to `flywheel`, reduced to that shaft
missing-losses = drive losses
missing-losses-how = the reducer has no losses; add `efficiency` to `[drive]` (it applies with a motor)
missing-flywheel = flywheel
missing-flywheel-how = the drive has none; add `flywheel` to `[drive]`
missing-friction = friction in pairs
missing-friction-how = the pairs are ideal, so their reactions do no work, and the reactions themselves cause no friction; `[[friction]]` with a coefficient gives a pair dry friction
missing-friction-given = the pairs are ideal, so their reactions do no work, and the reactions themselves cause no friction; { $forces }, against the motion, may stand for some of it, with the size that the scene gives
missing-friction-elsewhere = friction in the other pairs
missing-friction-elsewhere-how = pairs without a `[[friction]]` are ideal: their reactions do no work
missing-elasticity = elasticity of links
missing-elasticity-how = the links are rigid; an elastic part can be two links with a `[[spring]]` between them only where the mobility stays the same
missing-clearance = clearance in pairs, impacts
missing-clearance-how = pins and guides fit exactly; it can't be included (where a force in a guide changes its sign, the results report it)
missing-spatial = forces out of the plane
missing-spatial-how = the mechanism and all loads lie in one plane; it can't be included
report-no-json = the result can't be written as JSON: { $problem }
report-no-csv = the result can't be written as CSV: { $problem }
report-not-finite = the number found for `{ $place }` is not finite, so the results are not written
report-cell-not-finite = column `{ $column }`, row { $row }: the number found is not finite, and is not written
report-results-between = Results (extremes also between the positions and at jumps)
report-between = Extremes are found between the positions too, and on both sides of jumps.
report-friction = Friction in the pairs
report-friction-text = Dry friction: the moment of a pin acts on the link that turns on the journal, the force of a slide on the sliding link along the guide. The certificate is the spectral radius by which friction couples the reactions of a group: below 1 there is exactly one solution.
report-friction-table = Friction and its power
report-efficiency = Efficiency
report-friction-work = Losses of the pairs over the cycle
head-ideal-balancing = Without friction
head-efficiency = Efficiency
head-certificate = Certificate, { $group }
head-friction-work = Work
fact-efficiency = efficiency of the cycle
fact-self-braking = self-locking
fact-self-braking-narrow = self-locking at { $count } places, each shorter than { $step }; in all
fact-dead-angle = dead angle (no solution with friction)
report-inputs = Possible inputs
head-input = Input
report-simpler-inputs = With { $count ->
        [one] the link { $links }
       *[other] one of the links { $links }
    } as the input the groups would be of a lower class.
head-structure = Structural formula
report-passive = Passive: { $what } repeats constraints of other parts; positions are solved without it
report-misfit = { $what } is passive by count, but misses by { $misfit } at { $place } (limit { $limit }){ $closes }
report-closes = ; it closes with { $key } = { $value }
report-formula-without = { $formula }; passive: { $parts }
report-modes-of = Modes of group { $group } ({ $kind } { $links }) over the cycle
report-modes-unlisted = { $group }: its kind does not list its modes.
report-modes-together = { $group }: not listed. Shortly before { $coordinate } modes begin or end that can't be distinguished: some coincide over a part of the cycle, or several meet at one point, and rounding decides how many there are. Slightly different lengths separate them.
head-from = From
head-to = To
head-begins = Begins
head-ends = Ends
head-circuit = Circuit
head-branch = Branch
report-modes-from = { $count } from { $coordinate }
report-modes-count = Number of modes: { $counts }.
report-modes-circuits = { $circuits ->
        [one] One circuit
       *[other] { $circuits } circuits
    } (what is reached without taking the mechanism apart), { $branches ->
        [one] one branch
       *[other] { $branches } branches
    } (what is reached without a singular position).
report-modes-present = In the first position the mechanism is in mode { $mode }.
report-modes-meeting = { $one } and { $other } at { $coordinate }
report-modes-meet = Modes that meet and both go on: { $meetings }.
head-occurrence = Event
head-how = How
event-mode = mode { $mode } of group { $group }, circuit { $circuit }
event-mode-present = mode { $mode } of group { $group } (taken), circuit { $circuit }
event-mode-whole = over the whole cycle
event-mode-ends = begins { $begins }, ends { $ends }
event-meeting = modes { $one } and { $other } of group { $group } meet
event-side = { $guide } changes side
mode-end-cycle = with the cycle
mode-end-with = together with { $mode }
mode-end-infinity = links go to infinity
mode-end-barrier = groups solved before it can't be assembled
