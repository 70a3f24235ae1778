force-friction = group by group with dry friction in the pairs, all solutions
    .source = Artobolevsky, Theory of Mechanisms and Machines, friction in pairs; Ortega and Rheinboldt 1970, 13.1
    .wording = group by group with dry friction in the pairs, from the last Assur group back to the input link
force-friction-balance = the balancing load of `[balance]`
force-friction-input = the input link
