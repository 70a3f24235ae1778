# Names of loads that the scene does not name.
scene-unnamed-force = force { $number } on { $link }
scene-unnamed-moment = moment { $number } on { $link }
scene-unnamed-brake = brake { $number } on { $link }
scene-unnamed-spring = spring { $number }
scene-unnamed-contact = contact { $number } on { $link }

# Faults of a scene: what is wrong, the correction beside it, and what is allowed.
scene-more-faults = ... and { $more } more
scene-fault = error: { $message }
scene-place = { $file }, line { $line }, column { $column }
scene-did-you-mean = did you mean `{ $name }`?
scene-did-you-mean-letters = did you mean `{ $name }`? they look the same, but there are letters of another alphabet: { $codes }
scene-such-as = such as { $example }
scene-and-more = { $names } and { $more } more
scene-key = key
scene-knows = { $what } takes: { $keys }
scene-add-key = add `{ $key } = ...`
scene-needs-key = { $what } needs `{ $key }`
scene-problem-of-key = `{ $key }` { $problem }
scene-wants = wants { $wanted }, got { $got }
scene-unknown = unknown { $what } `{ $name }`
scene-write-once = write [{ $key }] once
scene-one-table = one table
scene-list-of-tables = a list of tables
scene-write-list = write [[{ $key }]]
scene-list-of-so-many = a list of { $count }
scene-in-quotes = in quotes
scene-an-empty-text = an empty text
scene-an-invisible-text = a text with invisible characters
scene-a-text = a text
scene-one-of = one of: { $words }
scene-true-or-false = true or false
scene-an-integer = an integer
scene-a-number = a number
scene-a-boolean = a boolean
scene-a-date = a date
scene-a-list = a list
scene-a-table = a table
scene-limit-not-negative = not negative
scene-limit-positive = greater than 0
scene-limit-direction = at most 1000 turns
scene-negative = must not be negative, got { $got }
scene-not-positive = must be greater than 0, got { $got }
scene-many-turns = is a direction and at most 1000 turns, got { $got }
scene-without-quotes = for { $unit } write it without quotes
scene-no-unit = has no unit: { $got }
scene-no-digits = results would have no digits: is the unit right?
scene-a-finite-number = a finite number
scene-refused-numbers = `nan`, `inf` and numbers beyond 1.8e308 are refused
scene-a-whole-number = a whole number from { $least } to { $most }
scene-such-as-or-in = such as { $example }, or a number in { $unit }
scene-got-no-number = `{ $text }`, which does not begin with a number
scene-comma = has a comma in the number `{ $number }`: the decimal sign is a point
scene-too-large = is too large: `{ $text }`, at most { $most }
scene-too-small = is too small: `{ $text }`, at least { $least } or 0
scene-got-unknown-unit = the unknown unit `{ $unit }`
scene-got-unit = `{ $unit }`, { $measures }
scene-no-quantity = no quantity of a scene
scene-dimension-plain-number = a plain number
scene-dimension-length = a length
scene-dimension-angle = an angle
scene-dimension-mass = a mass
scene-dimension-time = a time
scene-dimension-force = a force
scene-dimension-moment = a moment
scene-dimension-speed = a speed
scene-dimension-rotation = a speed of rotation
scene-dimension-acceleration = an acceleration
scene-dimension-angular-acceleration = an angular acceleration
scene-dimension-inertia = a moment of inertia
scene-dimension-stiffness = a stiffness
scene-dimension-damping = a damping coefficient
scene-dimension-power = a power
scene-with-units = { $quantity } ({ $units })
scene-a-scene = a scene
scene-file-too-large = { $what } has at most { $most } MiB, this one has { $size }
scene-many-tables = { $what } has at most { $most } tables and lists, this one has more
scene-right-file = is it the right file?
scene-unclosed = not TOML: this text has no closing quote
scene-begins-here = it begins here
scene-duplicate-key = not TOML: duplicate key `{ $key }`
scene-stands-already = it is already in line { $line }: write all its keys there
scene-no-quotes = write the number without quotes
scene-unquoted-key = not TOML: { $message }; a name with other characters must be in quotes
scene-no-toml = not TOML: { $message }
scene-long-name = `{ $name }` has { $count } characters, at most { $most } are read
scene-take-shorter = take a shorter one
scene-many-points = a scene has at most { $most } points on its links, this one has { $count }
scene-many-loads = a scene has at most { $most } loads, this one has { $count }
scene-many-slides = a scene has at most { $most } slides, this one has { $count }
scene-many-links = a scene has at most { $most } links, this one has { $count }
scene-one-too-many = one too many
scene-the-ground = the ground
scene-tables-of-links = tables [link.NAME]
scene-write-link = write [link.crank]
scene-add-links = add the moving links: [link.crank], [link.rod] ...
scene-no-length = link `{ $link }` has its pins { $pins } at one place: its length is zero
scene-give-length = give them different coordinates, or join the neighbors in one pin
scene-inertia-of-others = the formula of a moment of inertia depends on { $variables }
scene-inertia-of-q = it may depend on `q`, the input coordinate, alone
scene-inertia-not-smooth = `{ $function }` gives the moment of inertia a jump or a kink
scene-inertia-smooth = its derivative appears in the equation of motion: use smooth functions
scene-inertia-not-pinned = the moment of inertia of `{ $link }` varies, but no pin joins the link to the ground
scene-inertia-of-a-number = give a number, or join the link to the ground by a pin
scene-inertia-not-positive = `inertia` is { $value } kg*m^2 at q = { $at }
scene-inertia-positive = a moment of inertia must be positive and at most { $most } wherever the input goes
scene-no-link-name = `{ $name }` can't be the name of a link
scene-no-point-name = `{ $name }` can't be the name of a point
scene-what-is-a-name = a name must not be empty or contain a dot or invisible characters
scene-ground-as-link = the ground is not a moving link
scene-points-of-ground = its points belong in [ground]
scene-link-moment = a link can't have the name `moment`
scene-results-use-it = results use it: choose another name
scene-a-link = a link
scene-table-of-points = a table of points
scene-why-a-center = a link with a mass or inertia and not just one point needs it
scene-a-slide = a slide
scene-swap-slide = let the moving link slide on "ground"
scene-slide-on-itself = link `{ $link }` can't slide on itself
scene-another-link = another link or "ground"
scene-a-name = a name
scene-pin-and-slide = a pin and a slide have the name `{ $name }`
scene-two-slides = two slides have the name `{ $name }`
scene-own-name = give this one a `name` of its own
scene-name-of-a-link = the name of a link
scene-a-moving-link = a moving link
scene-name-of-a-point = the name of a point
scene-none-of-them = the scene has no { $what ->
    [link] links
    [point] points
    [slide] slides
   *[pair] pins or slides
 }
scene-all-of-them = { $what ->
    [link] links
    [point] points
    [slide] slides
   *[pair] pins or slides
 }: { $names }
scene-no-such-part = `{ $key }`: there is no { $what ->
    [link] link
    [point] point
    [slide] slide
   *[pair] pin or slide
 } `{ $name }`
scene-point-or-place = a point or [x, y]
scene-no-point-on-link = `{ $key }`: link `{ $link }` has no point `{ $point }`
scene-point-elsewhere = `{ $key }`: point `{ $point }` is not on link `{ $link }`, it belongs to: { $holders }
scene-link-without-points = it has none: give [x, y]
scene-points-of-link = its points: { $points }
scene-coordinates = [x, y] or one length on the x axis
scene-such-coordinates = such as [0, "-400 mm"] or "120 mm"
scene-needs-motion = { $what } needs a motion, and the scene has no [motion]
scene-add-motion = add [motion] with `speed`
scene-two-loads = two loads have the name `{ $name }`
scene-gravity-upward = `gravity` as one number points down and must not be negative
scene-or-both-components = or [gx, gy]
scene-a-force = a force
scene-a-moment = a moment
scene-a-brake = a brake
scene-ground-carries = the ground carries any load
scene-exclude = `{ $one }` and `{ $other }` exclude each other
scene-leave-one-out = leave one out
scene-why-an-angle = the direction: `angle`, or `against_motion = true`
scene-ground-does-not-turn = the ground does not turn
scene-a-spring = a spring
scene-a-contact = a contact
scene-two-points = two points, such as ["C", "D"]
scene-both-ends-on-link = both ends are on link `{ $link }`
scene-such-a-spring = such a spring keeps its length; give points of two different links
scene-point-of-link = a point, or "link.point"
scene-not-on-link = point `{ $point }` is not on link `{ $link }`
scene-belongs-to = it belongs to: { $holders }
scene-arc-of-a-link = the line is the ground's, the arc a link's
scene-during-backward = `during` ends before it begins
scene-during-nothing = `during` has equal ends: the contact never acts
scene-from-less-than-to = [from, to] with `from` less than `to`
scene-add-input = add [input] with `link`, the link that drives the others
scene-the-input = the input
scene-link-joined-to-ground = a link joined to the ground
scene-input-not-joined = the input link `{ $link }` is not joined to the ground
scene-join-the-input = a point that is also in [ground], or a [[slide]] on "ground"
scene-input-joined-often = the input link `{ $link }` is joined to the ground { $count } times: { $pairs }
scene-one-pair-of-input = it must have exactly one pin or slide there
scene-why-an-input = one of `link`, `slide` and `pin` says what drives
scene-of-a-pin = it belongs to a driven `pin`
scene-ends-of-pin = `{ $pin }` does not join `{ $of }` and `{ $on }`
scene-pin-joins = it joins: { $links }
scene-ground-is-on = the ground is what the link is driven against
scene-swap-of-and-on = swap `of` and `on`
scene-which-on = `{ $pin }` joins more than two links
scene-no-motor-between = `{ $key }` needs a link that is driven against the ground
scene-torque-between = give `torque`: the load of the drive between both links
scene-cycle-or-range = a whole cycle, or a range
scene-no-range = `to` equals `from`, but `positions` is { $positions }
scene-one-position-or-another-end = positions = 1, or another end
scene-why-to = a sliding input has no cycle of its own: give `to` or `cycle`
scene-an-input = an input
scene-law-over-time = a law over time
scene-needs-one-input = { $what } needs one input: with a list of inputs the coordinate is the time
scene-law-prescribes = { $what } has no place beside `over_time`, which prescribes the motion
scene-not-over-coordinate = { $what } needs an input without `over_time`: with it the coordinate is the time
scene-over-time-instead = give it over the time: a table with `over = "time"`, or a formula of `t`
scene-formula-of = a formula of { $variables }
scene-add-motion-until = add [motion] with `until`, the time at which it ends
scene-why-until = the time at which the motion ends
scene-why-a-law = a table of rows [time, coordinate], or a formula of the time `t`
scene-not-from-zero = begins at time 0, its first row is at { $got }
scene-single-row = needs two rows at least
scene-times-repeat = the times of the rows must grow
scene-law-without-jumps = a coordinate can't jump: leave the row out, or give it a later time
scene-until-beyond = `until` is { $until }, and the last row is at { $last }
scene-longer-or-closed = add rows, or end the motion there; only a table that ends with its first value repeats
scene-law-of-others = the formula of a law over time depends on { $variables }
scene-law-of-t = it may depend on `t`, the time in s, alone
scene-law-without-value = the law has a coordinate, speed or acceleration that is not finite or beyond all measure, at { $at }
scene-law-within-limits = it must hold from 0 to `until`
scene-driven-twice = two inputs drive the pair { $pair } of the same links
scene-the-motion = the motion
scene-other-motion = `{ $key }` belongs to a motion of kind "{ $owner }", this one is "{ $kind }"
scene-motion-knows = a { $kind } motion takes: { $keys }
scene-name-of-integrator = the name of an integrator
scene-large-tolerance = `tolerance` is relative and less than 1, got { $got }
scene-time-or-travel = { $time } or { $travel }
scene-end-of-motion = { $time }, { $travel }, "rest" or "turn"
scene-many-samples = `samples` may be at most { $most } in a scene of { $parts } links, points, slides and loads
scene-kept-in-memory = their numbers are kept in memory
scene-steady-without-cycle = a steady motion needs a cycle, and the input slides over a range
scene-give-a-cycle = give the input a `cycle`
scene-large-unevenness = `unevenness` is (max - min) / mean and less than 2, got { $got }
scene-leave-it-out = leave it out
scene-the-balance = the balance
scene-why-at-and-angle = a force has `at` and `angle`, a moment has neither
scene-the-output = the output
scene-list-of-names = a list of names
scene-ground-does-not-move = the ground does not move
scene-name-of-a-slide = the name of a slide
scene-name-of-a-pair = the name of a pin or slide
scene-pins = pins: { $pins }
scene-point-is-no-pin = point `{ $point }` is not a pin: it belongs to one link only
scene-the-note = the note
scene-list-of-positions = a list of numbers of positions
scene-here-are = this one has { $count }
scene-the-drive = the drive
scene-large-efficiency = `efficiency` is greater than 0 and at most 1, got { $got }
scene-drive-without-motion = [drive] needs a motion of kind "transient" or "steady", the scene has none
scene-drive-of-prescribed = [drive] needs a motion of kind "transient" or "steady", this one is "prescribed"
scene-kept-by-balance = a prescribed motion is kept by the balancing load
scene-key-of-motor = `{ $key }` belongs to a motor, and the drive has none
scene-add-motor = add `motor = ...` or leave it out
scene-flywheel-on-no-motor = the flywheel is on the motor, and the drive has none
scene-no-flywheel = `flywheel_on` without `flywheel`
scene-add-flywheel = add `flywheel = "solve"` or a moment of inertia
scene-input-slides = `{ $key }` needs an input that turns, this one slides
scene-solve-needs-steady = `{ $key } = "solve"` needs a motion of kind "steady"
scene-number-for-transient = give a number for a transient motion
scene-flywheel-needs-unevenness = `flywheel = "solve"` needs `unevenness` in [motion]
scene-unevenness-needs-motor = `unevenness = "motor"` needs a [drive] with a motor and `flywheel = "solve"`
scene-word-or = "{ $word }" or { $quantity }
scene-empty-drive = `motor`, `torque` or `flywheel`: an empty drive does nothing
scene-name-of-catalogue = the name of a catalogue
scene-kloss-needs-ratio = `characteristic = "kloss"` needs `max_torque_ratio`
scene-or-linear = or characteristic = "linear"
scene-key-of-catalogue = `{ $key }` belongs to a motor of a catalogue, this one is given by its data
scene-designation = a designation, "auto" or rated data
scene-a-motor = a motor
scene-no-slip = `rated_speed` must be less than `synchronous_speed`
scene-motor-slips = an asynchronous motor slips
scene-small-torque-ratio = `max_torque_ratio` must be greater than 1, got { $got }
scene-breakdown-by-rated = breakdown torque / rated torque
scene-a-formula = a formula
scene-table-over-angle = a table over angle
scene-table-over-time-or-speed = a table over time or speed
scene-table-over-stroke = a table over stroke
scene-stroke-of-a-force = only a force has a point whose stroke can be followed
scene-other-arguments = over = "angle" (or "coordinate"), "time" or "speed"
scene-scale-out-of-range = `scale` makes the size of the load { $size }, out of range
scene-right-unit-and-factor = results would have no digits: are unit and factor right?
scene-table-of-a-load = a table of a load
scene-all-arguments = over = "angle" (or "coordinate"), "time", "speed" or "stroke"
scene-a-unit = a unit
scene-formula-of-motion = a formula with `w` or `t`
scene-axis-without-x = `axis` has no use: the formula has no `x`
scene-x-along-axis = `x` is the place of the point along `axis`
scene-x-of-a-force = only a force has a point whose place `x` can be followed
scene-use-other-variables = use `q`, `w` or `t`
scene-repeat-without-cycle = `repeat` needs a cycle, and the input slides over a range
scene-long-table = the table spans { $span }, the cycle has { $cycle }
scene-shorten-table = `repeat = false`, a longer `cycle` of the input, or fewer rows
scene-forward-or-back = `forward`, `back` or both
scene-row-outside-stroke = has a row at { $at }: a stroke runs from 0 to 1
scene-list-of-rows = a list of rows
scene-no-rows = has no rows
scene-many-rows = has { $count } rows, at most { $most } are read
scene-leave-rows-out = leave rows out: between them lines are drawn
scene-rows-decrease = the first numbers of the rows must not decrease
scene-smaller-than-before = smaller than in the row before
scene-rows-of-two = rows of two numbers
scene-no-list = `{ $key }` is not a list
scene-single-value = `{ $key }` is a single value without parts
scene-table-is-no-list = { $owner } is not a list; it has: { $names }
scene-no-elements = { $owner } has 0 elements
scene-elements = { $owner } has { $count } elements, from [0] to [{ $last }]
scene-list-without-names = { $owner } is a list without names: name an element by its number, such as `{ $list }[0]`
scene-or-by-number = { $problem }, or name an element by its number, such as `{ $list }[0]`
scene-several-values = `{ $key }` names several values
scene-is-a-table = `{ $key }` is a table; it has: { $names }
scene-is-a-list = `{ $key }` is a list; it has: { $names }
scene-is-a-boolean = `{ $key }` is true or false, not a number
scene-is-a-date = `{ $key }` is a date, not a number
scene-the-scene = the scene
scene-default-not-written = a default must be written in the scene before it can be varied
scene-owner-has-no = { $owner } has no `{ $name }`; { $hint }; it has: { $names }
scene-nothing = nothing
scene-angle-of-sliding = the friction is `against_sliding`, and `angle` depends on more than the input coordinate
scene-law-over-coordinate = a number, or a table or formula over the input coordinate
scene-friction-against-sliding = friction against the sliding

## friction in pairs
scene-a-friction = a friction
scene-friction-in-free-motion = with dry friction in pairs a motion that follows from the equation of motion is driven at the input: it has no other balancing load
scene-friction-prescribed = leave `[balance]` out, or prescribe the motion (`kind = "prescribed"`)
scene-friction-twice = the pair { $pair } has its friction already
scene-friction-of-slides = `{ $key }` belongs to the friction of a slide, this pair is a pin
scene-friction-of-pins = `{ $key }` belongs to the friction of a pin, this pair is a slide
scene-friction-owner = the link `{ $link }` is not joined by this pin
scene-friction-without-length = `{ $key }` needs a contact of some length
scene-friction-add-length = add `length`, or leave it out
scene-hardly-meant = `{ $key }` = { $number } is taken in { $unit }, which is { $is }; write { $instead } if that was meant.
scene-formula-as-number = is a formula in place of a number: { $text }
scene-same-appearance = Point `{ $name }` ({ $codes }) looks like `{ $other }`, but has letters of another alphabet: these are two points.
scene-negative-length = Point `{ $point }` is given by one negative number, which is its coordinate x: the link is turned round, and its angle differs by 180 deg. A length is positive: write { $length }, or { $place } if the coordinate was meant.
scene-far-longer = Link `{ $link }` is { $length } long, the others about { $others }: is a unit wrong?
scene-great-inertia = The moment of inertia of link `{ $link }` has a radius of gyration of { $radius }; the mechanism measures { $size }: is a unit wrong?
scene-far-center = The center of mass of link `{ $link }` lies { $distance } from its points; the mechanism measures { $size }: is a unit wrong?
scene-long-links = Most links are about { $length } long: is a unit missing? A number without a unit is in m.
scene-friction-short-contact = must be at least 0.001 mm, got { $got }; without it the slide is pressed at one point

## the reference of the keys
scene-either = { $these } or { $last }
scene-kind-by-input = { $turning } where the input turns, { $sliding } where it slides
scene-kind-count = a whole number
scene-kind-name = the name of a { $what ->
    [link] link
    [point] point
    [slide] slide
    [pair] pin or slide
    [motor] motor
   *[plugin] plugin
 }
scene-kind-place = a point of the link, [x, y] in its frame, or a length on its x axis
scene-kind-two = a list of two: { $of }
scene-kind-list = a list: { $of }
scene-kind-table = a table: { $header }
scene-the-assembly = the assembly
scene-key-elsewhere = it belongs in { $tables }
scene-key-title = The title, for headings and pictures.
scene-key-gravity = Acceleration of gravity: one number points straight down, two are its components; absent, links have no weight.
scene-key-ground = The frame, link 0, with the points that stand still.
scene-key-link = The moving links; a point name used in two links is a pin between them.
scene-key-slide = Prismatic pairs: one link slides on another along a line.
scene-key-input = The input link, its coordinate and the positions that are calculated; or a list of inputs, [[input]], each over time.
scene-key-assembly = Roughly where points are in the first position: it chooses among the assembly modes of the groups.
scene-key-force = A force at a point of a link.
scene-key-moment = A moment on a link, counter-clockwise positive.
scene-key-spring = A spring, a damper or both between points of two links.
scene-key-contact = An arc of a link that rolls and slides along a straight line of the ground.
scene-key-friction = Dry friction in a pin or a slide; absent, the pair is ideal.
scene-key-brake = A shoe pressed on a disc: a moment against the motion of the link.
scene-key-balance = The load that keeps the prescribed motion; absent, it acts on the input link.
scene-key-motion = How the input moves; absent, there are transfer functions, and statics where there are loads.
scene-key-drive = Motor, reducer and flywheel, for a transient or steady motion.
scene-key-output = Only these are calculated; absent, everything that the scene makes possible.
scene-key-note = The title page and the language of `assur report`.
scene-key-points-of-ground = Points of the frame by name: [x, y], or one number on the x axis.
scene-key-points = Points by name in the link's own frame, whose origin and x axis are yours to choose: [x, y], or one number on the x axis. A name in two links is a pin; lengths of links are distances between their points.
scene-key-mass = Mass of the link; without it the link is massless.
scene-key-center = Center of mass; may be left out where the link has one point.
scene-key-inertia = Moment of inertia about the center of mass; of a link pinned to the ground also a formula over the input coordinate.
scene-key-slide-link = The link that slides.
scene-key-slide-on = The link that carries the guide, or "ground".
scene-key-slide-through = A point of the guide line, in the frame of the link that carries it; absent, the origin of that frame.
scene-key-slide-angle = Direction of the guide line, in the frame of the link that carries it.
scene-key-slide-point = The point of the sliding link that stays on the guide line; absent, its first point.
scene-key-slide-tilt = Angle of the x axis of the sliding link from the direction of the guide.
scene-key-slide-name = Its name in results; absent, link/on.
scene-key-input-link = The input link: pinned to the ground, or sliding on it.
scene-key-input-slide = In place of `link`, a slide that drives: between two moving links a cylinder; the coordinate is its displacement.
scene-key-input-pin = In place of `link`, a pin that drives: a motor in the joint of two links; the coordinate is the angle of the x axis of `of` minus that of `on`.
scene-key-input-of = The link that a driven pin turns.
scene-key-input-on = The link against which a driven pin turns `of`; needed where the pin joins more than two links.
scene-key-input-from = Coordinate of the first position: the angle of the link's x axis, or the displacement of its slide.
scene-key-input-positions = How many positions are calculated: equally spaced over the cycle, its end not repeated.
scene-key-input-cycle = The travel of the input after which everything repeats; absent, one turn.
scene-key-input-direction = The sense in which the coordinate moves: "ccw" grows, "cw" decreases.
scene-key-input-to = Coordinate of the last position, in place of a cycle; a sliding input needs it or a cycle.
scene-key-input-name = What the coordinate is called on axes and in tables; absent, "coordinate" and the input link.
scene-key-input-over-time = The coordinate over time, in place of `from` and what moves it: [motion] then has `until` and `samples` alone.
scene-key-inputs-from = The coordinate at time 0: the angle of the link's x axis, or the displacement of its slide.
scene-key-input-rate = What the coordinate grows by in a second, with its sign; without [motion] it is not used.
scene-key-time-table = Rows [time, coordinate], the first at time 0, times ascend; a table that ends with its first value repeats.
scene-key-time-shape = Rows are joined by straight lines, between which the speed jumps, or by a cubic spline: natural, or periodic where the first value equals the last.
scene-key-time-formula = A formula of t (time, s) alone, in rad or m; speed and acceleration are its derivatives.
scene-key-assembly-point = A point of the mechanism and roughly where it is in the first position.
scene-key-load-name = Its name in results and in keys.
scene-key-load-link = The link on which it acts.
scene-key-scale = A factor on the size of the load, to be varied.
scene-key-force-at = The point of the link at which the force acts.
scene-key-force-angle = Direction of the force, counter-clockwise from the x axis; a force that resists points against the motion.
scene-key-force-frame = In whose frame the angle is counted: that of the ground, or of the link.
scene-key-value = Its size: a number, a table over angle, time, speed or stroke, or a formula.
scene-key-against-motion = In place of an angle: the force is always opposite to the velocity of its point.
scene-key-spring-between = Its two ends: points of two links, written "link.point" where a name is not enough.
scene-key-spring-stiffness = Stiffness of the spring.
scene-key-spring-length = Free length of the spring.
scene-key-spring-damping = Damping along the line between the ends.
scene-key-contact-center = Center of the arc.
scene-key-contact-radius = Radius of the arc.
scene-key-contact-angle = Where the force acts on the arc, from its lowest point clockwise.
scene-key-contact-force = The force on the arc, towards its center.
scene-key-contact-friction = Coefficient of friction with its sign, or a table whose sign follows from the sliding.
scene-key-contact-during = The interval of the input coordinate in which there is contact; absent, always.
scene-key-against-sliding = Coefficient of friction that opposes the sliding.
scene-key-brake-radius = Radius of the disc.
scene-key-brake-force = The force on the lever.
scene-key-brake-lever = The factor by which the lever multiplies the force.
scene-key-brake-friction = Coefficient of friction between shoe and disc.
scene-key-over = What the value depends on: the input coordinate, time, the input speed, or the stroke of the force's point.
scene-key-table = Rows [argument, value] in ascending order; two rows with one argument make a jump.
scene-key-shape = Rows are joined by straight lines, or each value holds up to the next row.
scene-key-repeat = Whether a table over angle repeats with the cycle; absent, it does where there is one.
scene-key-axis = The direction along which the stroke of the point is measured.
scene-key-forward = The value while the point moves along the axis: a number, or rows over its place from 0 to 1.
scene-key-back = The value while the point returns: a number, or rows over its place from 0 to 1.
scene-key-formula = A formula of q (coordinate, rad or m), w (speed, positive along `direction`: a resistance to the input is -5*w where it turns ccw, 5*w where cw), t (time), x (place of the point along the axis, 0 to 1), in SI, with sin cos tan asin acos atan atan2 sqrt exp ln abs sign min max step pi; angles in radians.
scene-key-inertia-formula = A formula of q, the input coordinate, that is smooth and positive wherever the input goes.
scene-key-unit = Unit of the formula's result; absent, SI.
scene-key-friction-pair = The pin or slide in which the friction acts.
scene-key-friction-coefficient = Coefficient of friction.
scene-key-friction-radius = Radius of the journal.
scene-key-friction-owner = The link whose journal it is; absent, the ground, else the first link of the pin in the order of the file.
scene-key-friction-length = Length of contact along the guide: force and moment press on its ends; absent, it is pressed at one point.
scene-key-friction-middle = What the middle of the contact travels with: the point of the sliding link, or the guide.
scene-key-friction-offset = Distance of the sliding faces from the guide line, on both sides; it needs a length.
scene-key-balance-link = The link on which the balancing load acts.
scene-key-balance-at = Point of a balancing force; without it there is a moment.
scene-key-balance-angle = Direction of a balancing force.
scene-key-motion-kind = Prescribed: speed and acceleration are given; transient: it follows from loads and drive; steady: the periodic regime.
scene-key-motion-speed = Speed of the input along its direction in the first position; a prescribed motion needs it, a transient one starts from rest without it.
scene-key-motion-acceleration = Acceleration of the input along its direction.
scene-key-motion-until = The end: a time, a travel of the input, "rest" for good, or "turn", the first reversal; of a motion over time a time.
scene-key-motion-samples = How many equally spaced instants after the first are given.
scene-key-motion-integrator = A registered method (`assur plugins`); "auto" chooses one.
scene-key-motion-tolerance = Relative tolerance of the integration.
scene-key-motion-step = Step of methods with a fixed step: a time, or a travel of the input.
scene-key-motion-max-steps = After so many steps the integration gives up.
scene-key-motion-mean-speed = Mean of the greatest and the least speed of the input.
scene-key-motion-unevenness = (max - min) / mean of the input speed; "motor": the greatest for which the motor stays on its working section.
scene-key-drive-motor = A designation of the catalogue, "auto" for the smallest that suits, or rated data.
scene-key-drive-catalogue = The catalogue in which the motor is looked up (`assur plugins`).
scene-key-drive-max-motor-speed = Greatest synchronous speed of a motor that "auto" takes.
scene-key-drive-characteristic = Moment over speed: by Kloss's formula, or the straight working section.
scene-key-drive-ratio = Motor speed over input speed; "solve" finds it.
scene-key-drive-efficiency = Efficiency of the reducer.
scene-key-drive-torque = In place of a motor: a constant moment (a force, for a sliding input) along the direction; "balance" makes the work of a cycle zero.
scene-key-drive-flywheel = Moment of inertia of a flywheel; "solve" finds it from the unevenness.
scene-key-drive-flywheel-on = The shaft that carries the flywheel.
scene-key-motor-power = Rated power.
scene-key-motor-synchronous-speed = Synchronous speed.
scene-key-motor-rated-speed = Rated speed, less than the synchronous one.
scene-key-motor-max-torque-ratio = Breakdown torque over rated torque; "kloss" needs it.
scene-key-motor-inertia = Moment of inertia of the rotor.
scene-key-output-names = Names of those that are calculated; groups on which none of them depends are not solved.
scene-key-note-author = Who wrote it.
scene-key-note-group = The author's group.
scene-key-note-variant = Variant of the task.
scene-key-note-language = Language of note, drawings and texts.
scene-key-note-positions = Numbers of the positions that are drawn and worked out; absent, the program chooses.
scene-key-of-sorts = it belongs to another kind: { $sorts }

## what is hardly meant in loads and motion
scene-typographic-quotes = these are the quotes of a word processor: write " before and after
scene-unquoted-quantity = a number with a unit is written in quotes: "{ $value }"
scene-decimal-comma = is the comma meant as a decimal separator? it must be a point
scene-small-inertia = The moment of inertia of link `{ $link }` has a radius of gyration of { $radius }, and the link is { $size } long: is a unit wrong?
scene-far-heavier = Link `{ $link }` has a mass of { $mass }, the others about { $others }: is a unit wrong?
scene-odd-gravity = Gravity is { $size }; on Earth it is 9.81 m/s². Write "9.81 m/s^2", or leave `gravity` out.
scene-fast = Links would reach { $speed } and more, which no material withstands: is the speed meant in another unit?
scene-rough = A coefficient of friction of { $found } occurs in no pair of solids; is it a percentage?
scene-great-journal = The journal has a radius of { $radius }, and the mechanism measures { $size }: is a unit wrong?
scene-empty-output = [output] names nothing, so nothing is calculated: name points, links, slides or reactions, or leave it out.
scene-long-spring = The spring has a free length of { $length }, and the mechanism measures { $size }: is a unit wrong?
scene-spring-without-stiffness = The spring has neither `stiffness` nor `damping`, so it has no force: is its stiffness missing?
scene-strong = The load is that of a force of { $force } on a mechanism of { $size }, which no steel would withstand: is a unit wrong?
scene-long-time = The table over time goes up to { $last }, and the motion lasts { $lasts }: is the time meant in another unit?
scene-drives-clockwise = This moment drives the input at every speed: `w` is the speed along `direction`, and a moment is counter-clockwise positive; a resistance to an input that turns clockwise is positive, `5*w`.
scene-degrees-in-formula = `{ $function }` takes radians, and here its argument looks like degrees: write 30*pi/180 for 30 degrees, and q is in radians already.
scene-negative-against = A negative `value` against the motion drives: leave the minus sign out.
scene-key-at-top = it belongs at the top of the file, before the first [table]
scene-comment-sign = not TOML: a comment begins with `#`
scene-colon = not TOML: a key and its value are joined by `=`
scene-semicolon = not TOML: a line ends without `;`
scene-round-brackets = not TOML: coordinates and lists are written in square brackets: [x, y]
scene-invisible-sign = not TOML: there is an invisible character { $code } here: write a space in its place
scene-missing-comma = not TOML: a comma is missing between two values
scene-unclosed-brace = not TOML: this brace has no closing one in its line
scene-missing-value = not TOML: a value is missing here
scene-unquoted-text = not TOML: a text is written in quotes: "{ $value }"
scene-form-of-number = not TOML: write the number as { $number }
scene-unclosed-header = not TOML: the name of this table has no closing bracket
scene-key-without-value = not TOML: after the key `{ $key }` come `=` and its value
scene-example-or-word = { $example }, or "{ $word }"
scene-grouped-digits = has a space in the number: `{ $text }`; write its digits together
scene-degrees-in-table = a bare number is in radians: write "360 deg" for degrees
scene-list-repeats = With `to`, { $positions } positions are { $apart } apart and the last one repeats the first: leave `to` out, or write positions = { $more }.
scene-part-of-a-turn = A cycle of { $cycle } is not a whole number of turns: after it the mechanism is not where it began. Positions of a part of a turn are written with `to`.
scene-gravity-up = Gravity points up: y grows upward. Write "9.81 m/s^2", or [0, "-9.81 m/s^2"].
scene-inertia-without-mass = Link `{ $link }` turns about no fixed pin and has a moment of inertia, but no mass: is `mass` missing?
scene-mass-without-inertia = Link `{ $link }` turns and has a mass, but no moment of inertia, which the others have: it is taken as 0; add `inertia` (0 if that is meant)
scene-far-lighter = Link `{ $link }` has a mass of { $mass }, the others about { $others }: is a unit wrong?
scene-turned-twice = A negative speed along direction = "cw" turns counter-clockwise: leave the minus sign out.
scene-odd-ratio = `ratio` is motor speed / input speed; with { $ratio } the motor is far from its rated speed, { $needed } would reach it.
scene-great-torque-ratio = `max_torque_ratio` = { $found } is a breakdown torque of { $found } times the rated one, where motors have 1.5 to 4; write { $part } if a percentage was meant.
scene-table-ends = The table ends at { $last }, and the cycle at { $end }: { $held } is held up to there, then it jumps to { $first }. If that is meant, write `repeat = true`, else a row at { $end }.
scene-unevenness-unused = `unevenness` has no effect: it determines a flywheel, and none is to be found. Write flywheel = "solve" under [drive], or leave it out.
scene-counted-twice = { $point } stands at { $angle } in the frame of the input link, and `from` turns this frame by as much again: { $point } begins at { $twice }. Put { $point } on the x axis of its link, or leave `from` out.
scene-the-sheet = the sheet
scene-list-of-fields = a list of fields
scene-many-positions-of-sheet = `{ $key }` of a sheet has at most { $most } positions
scene-key-sheet = Format, fields and title block of `assur sheet`.
scene-key-sheet-format = Its format; absent, the smallest that holds the fields.
scene-key-sheet-positions = The positions drawn over each other: how many over the cycle, or their numbers.
scene-key-sheet-plans = Numbers of the positions of plans and polygons; absent, those of the note.
scene-key-sheet-fields = Its fields in their order, of `mechanism`, `diagrams`, `velocities`, `accelerations`, `forces`, `lever`, `dynamics`, `results`; absent, those that the scene has.
scene-key-sheet-number = The number of the drawing, for the title block.
scene-a-text-by-language = a text or a table of languages
scene-text-by-language = a text by languages
scene-an-empty-table = an empty table
scene-table-of-labels = a table of points with their labels
scene-write-labels = such as [labels] with A = "A₁"
scene-columns-of-a-diagram = columns of the results with commas between them
scene-list-of-diagrams = a list of diagrams
scene-list-of-chapters = a list of chapters
scene-many-of-note = `{ $key }` of a note has at most { $most } entries
scene-key-labels = What readers call the points.
scene-key-labels-point = What readers call this point; files and keys have its name.
scene-key-label = What readers call it, in one language or several; files and keys have its name.
scene-key-language-en = The text in English.
scene-key-language-uk = The text in Ukrainian.
scene-key-language-ru = The text in Russian.
scene-key-note-ministry = The ministry of the university, for the cover.
scene-key-note-university = The university, for the cover.
scene-key-note-department = The department, for the cover.
scene-key-note-discipline = The discipline, for the cover.
scene-key-note-supervisor = Who supervises the work.
scene-key-note-city = The city, for the cover.
scene-key-note-year = The year, for the cover.
scene-key-note-task = The text of the task; an empty line divides its paragraphs.
scene-key-note-curves = Further diagrams: columns by heading, CSV name or words; several with commas between them lie over each other.
scene-key-note-chapters = The chapters that it has, of results, task, structure, kinematics, forces, dynamics, energy, working, checks, model, sources, conclusions; absent, all that the scene has.
scene-key-note-digits = Significant digits of its numbers.
