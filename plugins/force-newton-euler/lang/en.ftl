force-newton-euler = one linear system for all links: every reaction and the balancing load, without groups
    .source = equilibrium of each link with its inertia loads (d'Alembert); sparse elimination with partial pivoting
    .wording = by one linear system of the equations of equilibrium of all links
force-newton-euler-unbalanced = { $equations } equations of equilibrium for { $unknowns } unknown reactions
force-newton-euler-all = the mechanism
force-newton-euler-open-friction = the reaction of the pair { $pair }, which has friction, is not determined beside the passive links
