force-friction = group by group with dry friction in the pairs, all solutions
    .source = Artobolevsky, Theory of Mechanisms and Machines, friction in pairs; Ortega and Rheinboldt 1970, 13.1
force-friction-balance = the balancing load of `[balance]`
force-friction-input = the input link
