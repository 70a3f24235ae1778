group-any = any group, by iteration; it does not list its assemblies
    .ways = not listed: the one that is reached from the places in [assembly]
    .singular = the constraints of the pairs depend on each other
    .source = Newton's method with shortened steps, the root certified by the theorem of Newton and Kantorovich; derivatives and reactions by the linear system of the pairs
