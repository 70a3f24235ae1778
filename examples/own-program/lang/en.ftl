own-plates = two links with three inner pairs each, joined to each other, and four links on outer bodies
    .ways = the one near the places of [assembly]
    .singular = the constraints of the pairs are dependent
    .source = Newton's method on the constraints of the pairs
