group-any = any group, by iteration; its assembly modes are not listed
    .ways = not listed: the one reached from the places in [assembly]
    .singular = the constraints of the pairs are dependent
    .source = Newton's method with shortened steps, the root certified by the theorem of Newton and Kantorovich; derivatives and reactions by the linear system of the pairs
