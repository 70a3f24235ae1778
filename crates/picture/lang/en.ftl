# What is written in pictures.
friction-circle = { $reaction }: friction circle { $radius }
friction-cone = { $reaction }: friction angle { $angle }
friction-cone-of-ends = { $reaction }: friction angle { $angle }, both ends pressed
places-motor = motor
places-motor-as = motor, size and mass of { $other }
places-gear = gear
places-crank = crank
places-title = on the { $shaft }
places-with-mass = on the { $shaft }: { $sum } in all
regime-unevenness = unevenness
regime-least-speed = least speed
regime-greatest-speed = greatest speed
regime-input-speed = input speed
regime-course = regime
regime-first-turn = first turn
regime-moments = moments on the input
regime-forces = forces on the input
regime-motor = motor
regime-driving-loads = driving loads
regime-resistance = resistance
regime-mean = mean
regime-whole = whole
regime-delta = δ = { $delta }
regime-working-section = working section
regime-motor-speed = speed of the motor, rad/s
regime-characteristic = motor characteristic, N·m
regime-links-inertia = reduced inertia of the links
regime-links-mass = reduced mass of the links
regime-work = work
regime-energy-mass = energy-mass diagram, work in joules
regime-shares = reduced inertia, { $unit }: { $names }
regime-drive = drive
regime-start = start
regime-end = end
regime-ends = input speed at the ends of each cycle
regime-cycle = cycle
regime-ratio = ratio
regime-flywheel = flywheel
regime-parts = trials, as parts of the values found
regime-trial = trial
regime-driving-work = driving work
regime-resisting-work = resisting work
regime-friction-work = friction work
regime-kinetic-energy = kinetic energy
regime-energies = energies, J
motion-loads = moments of the loads on the input
motion-forces = forces of the loads on the input
motion-over-time = time
motion-coordinate = coordinate
motion-time = time, s
regime-against = { $load }, against the motion
regime-excess-area = A* = { $work }
instant-at = instant { $instant }, { $time }, { $at }
position-at = position { $position }, { $at }
no-motion-found = The motion that the scene asks for was not found:
arrow-velocity = velocity
arrow-acceleration = acceleration
arrow-first = PF1: for unit speed
arrow-second = PF2: for unit speed
index-of-balancing = bal
index-of-drive = d
index-of-friction = f
index-of-flywheel = fl
acting-flywheel = inertia of flywheel and rotor
acting-friction = friction in { $of }
acting-friction-of-slide = friction in { $of }, a part of the reaction
forces-analyzer = force analyzer: { $method }
forces-calculating = force analyzer: { $method }; the difference is being calculated
forces-two-analyzers = 1 { $one } (line)  2 { $other } (stars)   largest difference { $difference }
forces-hodograph = hodograph: { $reaction }
forces-path = path of the tip over the cycle
forces-numbers = positions, by their numbers
curve-zero = zero
curve-extreme = extreme
curve-inflection = inflection
curve-compared = { $quantity }   1 { $one } (line)  2 { $other } (stars)
curve-before = { $quantity }   1 now (line)  2 before (dots)
drive-title = drive
places-heading = drive with its flywheel on either shaft
regime-reduced = reduced to { $point }: F { $force }, m { $mass }
following-path = path of { $point }
following-transmission = transmission angle
motion-none = no [motion] in the scene, so only J and Q; add it, with speed = "60 rpm"
plans-no-construction = no method with a construction fits here
lever-of-drive = balancing load, that of the drive with the inertia of flywheel and rotor
plans-too-small = too small to be drawn at this scale: { $names }
plans-no-force = No force acts on these links here: their loads are moments that balance each other, or there are none, so the reactions are zero and there is no polygon.
plans-step = { $construction }, step { $step }
plans-more = and { $count } more, in the list of the plan
say-lost = no assembly in { $place }; { $group }
say-lost-beyond = no assembly in { $place }; { $group }; it exists from { $from } to { $to }
say-misses = no assembly: misses by { $gap } in { $place }; { $group }
say-no-assembly = no assembly: { $reason }
say-misses-beyond = no assembly: misses by { $gap } in { $place }; { $group }; it exists from { $from } to { $to }
reduction-mechanism = the mechanism
reduction-model = disc: M = { $moment }, J = { $inertia }
reduction-with-flywheel = { $told } (with flywheel and rotor)

# What there is no picture of, and what to add to the scene.
add-motion = This scene has no motion, and no masses to reduce. Add to the scene, for example:

    {"    [motion]"}
    {"    speed = \"60 rpm\""}

    or kind = "transient" (from an initial state), or kind = "steady" (the periodic regime).
add-drive = This scene has no steady regime of a drive. Add to the scene, for example:

    {"    [motion]"}
    {"    kind = \"steady\""}
    {"    mean_speed = \"60 rpm\""}
    {"    unevenness = 0.05"}

    {"    [drive]"}
    {"    motor = \"auto\""}
    {"    ratio = \"solve\""}
    {"    flywheel = \"solve\""}
drive-over-time = This scene moves by laws over time, whatever loads that takes: view 5 has the drives, view 3 their loads. A motor, a regime and a flywheel need one input without a law.
add-loads = This scene has no loads, so there are no forces. Add to the scene, for example:

    {"    [[force]]"}
    {"    link = \""}{ $link }{"\""}
    {"    at = \""}{ $point }{"\""}
    {"    angle = \"180 deg\""}
    {"    value = \"1500 N\""}

    or gravity = "9.81 m/s^2" and masses.
drive-no-motor = this regime has no motor from a catalogue
forces-not-determined = no forces are determined in this position
no-forces-found = There are no forces, since the motion that the scene asks for was not found:
nothing-here = this scene has nothing for this view
events-no-dead-angle = Dead angles: none; some moment of the input moves the mechanism everywhere.
events-of-turn = Modes are told of a whole turn, of which the positions are a part.
events-title = Events of the cycle: modes, friction, sides of guides
assembly-input-link = Input link { $formula }
assembly-reaction = reaction in { $of }
assembly-inner-reaction = reaction within the group
assembly-inner-moment = moment of the reaction within the group
assembly-group = group { $formula }
curve-angle = angle
curve-displacement = displacement
