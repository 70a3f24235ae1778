kinematics-position = position { $number }
kinematics-coordinate = coordinate { $coordinate }: { $cause }
kinematics-range = the mechanism can be assembled from { $low } to { $high }
kinematics-no-range = it can't be assembled in the first position: check the lengths{ $units } and the directions of guides, or start elsewhere (`input.from`)
kinematics-units = {" "}and their units (a number without one is in meters)
kinematics-no-start = { $group } is solved by iteration, which needs a starting position: say in [assembly] roughly where these points are in the first position: { $points }
kinematics-through-origin = the guide of `{ $slide }` goes through the origin of `{ $on }`, as it does without `through`: give `through` if it should not
kinematics-parallel-guides = { $group } can't be placed anywhere: the guides of `{ $one }` and `{ $other }` are parallel, so the link between them is held by neither; turn one of them (`angle`)
