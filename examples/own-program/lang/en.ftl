own-triad = a link with three inner pairs, and three links on outer bodies
    .ways = the one near the places of [assembly]
    .singular = with pins alone: the lines of the three outer links through one point, or parallel
    .source = Newton's method on the constraints of the pairs
