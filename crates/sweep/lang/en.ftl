# Sweeps: what is measured, and why one can't begin.
sweep-vary = `{ $vary }`: { $problem }
sweep-nothing-varied = nothing is varied: name a parameter, such as "link.crank.mass=1 kg..5 kg:9"
sweep-twice = `{ $first }` and `{ $second }` are the same value of the scene: vary it once
sweep-many-points = the sweep has { $points } points, at most { $most } are calculated: use fewer values of each parameter
sweep-uncounted-points = the sweep has too many points, at most { $most } are calculated: use fewer values of each parameter
sweep-many-parameters = the sample has { $count } parameters, at most { $most } are allowed: keep those that matter
sweep-no-measure = there is no measure `{ $name }`: choose from { $measures }, or `default` or `all`
sweep-all-refused = no point of the sweep can be calculated; the first, { $point }:
    { $problem }
sweep-no-threads = can't start { $threads } threads: { $problem }
sweep-write-grid = write it as KEY=FROM..TO:N, such as "link.crank.mass=1 kg..5 kg:9"
sweep-write-sample = for a sample write it as KEY=FROM..TO, such as "link.crank.mass=1 kg..5 kg"
sweep-wrong-count = N is `{ $count }`: write a whole number from 1
sweep-no-number = `{ $text }` does not begin with a finite number
sweep-count = `{ $key }` is a count, it has no unit
sweep-text = `{ $key }` is a text, not a number: list texts, KEY=A,B
sweep-takes-no-number = `{ $key }` takes no number
sweep-different-ends = FROM and TO are different quantities
sweep-measure-health = least determinant of all groups over the positions, and where
sweep-measure-transmission = least transmission angle of all groups, and where
sweep-measure-balancing = balancing load: greatest magnitude and where, mean, mean magnitude
sweep-measure-balancing-rms = root mean square of the balancing load
sweep-measure-reactions = greatest force in each pair, greatest moment of each slide
sweep-measure-reaction-rms = root mean squares of these forces and moments
sweep-measure-extremes = extremes of points, slides and angles of links over the positions
sweep-measure-stroke = stroke of each slide and swing of each link, exact between positions too
sweep-measure-time-ratio = ratio of the times of the slower and the faster stroke of slides and links that swing; between positions too
sweep-measure-regime = periodic regime and drive
sweep-measure-end = the last state of a transient motion
sweep-measure-friction = dry friction over the cycle: efficiency, work, 1 minus the greatest spectral radius, lengths of self-locking and of dead angles
sweep-several-quantities = it can measure several things: write FROM and TO with a unit
sweep-at-position = position { $position }: { $problem }
sweep-in-line = { $problem } (line { $line })
sweep-not-finite = the number found for `{ $column }` is not finite
sweep-misfit = the passive links fail to fit by { $misfit } over the cycle
sweep-write-tie = write it as KEY=KEY, KEY=KEY*FACTOR or KEY=KEY*FACTOR+CONSTANT; the second key is varied
sweep-write-best = write it as least:COLUMN or greatest:COLUMN
sweep-no-column = there is no column { $column }: one of { $columns }; --measure adds others
sweep-tie-not-varied = it follows `{ $key }`, which is not varied: name that key in --vary
sweep-tie-other-quantity = it is { $own } and would follow `{ $key }`, { $other }: write the factor in SI units (even *1) if that is meant
sweep-measure-pf = greatest magnitudes of the first and second transfer functions of points, slides and links, between positions too
sweep-measure-speed = greatest speeds of points, slides and links at a constant speed of the input, between positions too
sweep-measure-acceleration = greatest accelerations of points, slides and links at a constant speed of the input, between positions too
sweep-measure-shaking = shaking force on the ground: greatest, root mean square; greatest shaking moment about the origin, between positions too
sweep-measure-distance = least and greatest distance of points from the places of --target, between the positions too
sweep-write-target = write it as POINT=X,Y, such as "E=100 mm,50 mm"
sweep-other-unit = a number without a unit is in { $unit }, and the scene has { $own }; write "{ $instead }" if that is meant
sweep-far-target = this is { $away } from the origin, and the mechanism measures { $size }: a number without a unit is in m; write "{ $instead }" if that is meant
sweep-no-point = there is no such point in the results; points: { $points }
sweep-other-scene = the scene was a different one
sweep-other-origin = `{ $key }` was { $was } and is { $is }
sweep-nothing = nothing
sweep-measure-plain = least and greatest value, mean and root mean square of what a position has under this key in the JSON
sweep-tie-to-texts = it follows `{ $key }`, whose values are texts: tie it to a number
sweep-at-line = { $file }, line { $line }: { $problem }
sweep-at-row = { $file }, row { $row }: { $problem }
sweep-table-column = column of { $file }: { $problem }
sweep-table-cells = it has { $cells } cells, the header has { $columns }
sweep-table-size = a table of points has at most { $most } cells
sweep-table-empty = { $file } has no points: its columns are keys of the scene, its rows are points
sweep-uneven-lists = the parameters have different numbers of values: { $counts }
sweep-other-shape = `{ $word }` changes the links, the groups or the columns: sweep it as a scene of its own
sweep-write-where = write it as COLUMN > VALUE, with <, <=, > or >=, such as "transmission > 40 deg"
sweep-where-several = it has several columns, name one: { $columns }
sweep-where-bare = write a number without a unit: it is in the unit at the end of `{ $column }`
sweep-status-ok = ok
sweep-status-no-assembly = no assembly
sweep-status-no-solution = no solution
sweep-status-error = error
sweep-status-refused = refused
