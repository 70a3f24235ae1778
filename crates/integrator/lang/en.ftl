integrator-sort = integrator
integrator-state = t = { $time } s, q = { $coordinate }, w = { $speed }
integrator-out-of-range = (out of range)
integrator-inertia-constant = J constant
integrator-moment-constant = M constant
integrator-by-name = chosen by name
integrator-choice = case { $case } of D ({ $equation }): { $reason }
integrator-tried-before = `{ $method }` was tried before: { $why }
integrator-stiff = the equation is stiff: an explicit method had to keep h*lambda at { $product }
integrator-inertia-not-positive = the reduced inertia is { $inertia }: it must be positive (give some moving link a mass)
integrator-acceleration-not-finite = the acceleration is not finite, with the reduced inertia { $inertia } and the reduced moment { $moment }: where the links that move have no inertia, as at a dead center, give the input link some
integrator-coordinate-out-of-range = the coordinate is { integrator-out-of-range }: the motion gains speed without limit
integrator-bad-request = bad request: { $fault }
integrator-unsupported = integrator `{ $method }` does not support this equation: { $reason }
integrator-no-method = no linked integrator supports this equation ({ $equation })
integrator-step-too-small = the motion can't be followed beyond { $state }: the tolerance asks for steps below { $step } s; loosen it, or look for a load or an inertia that grows without limit there
integrator-too-many-steps = the motion got to { $state } in { $steps } steps, the most that are allowed; the last one was { $step } s; { $advice }
integrator-advice-stiff = the equation is probably stiff (h*lambda = { $product }: stability, not accuracy, holds the step): use `radau5`
integrator-advice-not-stiff = it does not look stiff (h*lambda = { $product }): { integrator-advice }
integrator-advice = loosen the tolerance, allow more steps (`max_steps`), or end the motion earlier (`until`)
integrator-unstable = the fixed step { $step } s is unstable at { $state }: h*lambda = { $product }, at most { $allowed } is allowed; take a step below { $below } s, or `radau5` if the equation is stiff
integrator-end-of-range = the motion reaches the end of its range at { $state }: { $cause }; end it before (`until`), or check whether the mechanism should pass there
integrator-no-value = the equation of motion has no value after { $state }: { $cause }
integrator-not-reached = { $goal } is never reached: the motion got to { $state } and { $why }
integrator-empty-piece = the equation of motion gave an empty piece at { $state }: its bounds must lie ahead of the motion
integrator-goal-time = time { $time } s
integrator-goal-coordinate = coordinate { $coordinate }
integrator-goal-turn = a turning point
integrator-goal-rest = rest
integrator-creeps = creeps to rest without end
integrator-many-events = has a million jumps, reversals and stops, and does not end
integrator-swings = swings between two turning points without end
integrator-endless = goes on without end
integrator-keeps-speed = keeps its speed
integrator-rests = rests there for good
integrator-moves-away = moves away from it at constant speed
integrator-time-is-over = reached the time limit
integrator-nothing-brings = nothing takes it there
integrator-start-not-finite = the initial state ({ $state }) is not finite
integrator-bad-tolerance = tolerance { $tolerance }: must lie between 0 and 1
integrator-bad-counts = samples and max_steps must be at least 1
integrator-bad-step = fixed step { $step }: must be positive
integrator-end-before-start = end at { $end } s: must be after the start at { $start } s
integrator-end-at-start = end at coordinate { $end }: the motion is already there at the start
integrator-bad-end = end at coordinate { $end }
integrator-end-near-start = end at coordinate { $end }: too near to the start at { $start } to be distinguished from it
integrator-bad-limit = time limit { $limit } s: must be after the start at { $start } s
integrator-both-directions = with dry friction the motion may start from rest in either direction, with the acceleration { $up } or { $down }: which one it takes is not determined (Painlevé); lower the coefficients of friction
