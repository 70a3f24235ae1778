integrator-dopri5 = Dormand-Prince 5(4), explicit, adaptive, dense output of order 4
    .source = Hairer, Norsett, Wanner I, II.5
integrator-dopri5-suits = a loose tolerance: cheap explicit steps of order 5 meet it
integrator-dop853 = Dormand-Prince 8(5,3), explicit, adaptive, dense output of order 7
    .source = Hairer, Norsett, Wanner I, II.5 and II.6
integrator-dop853-suits = a tight tolerance: explicit steps of order 8 meet it with the fewest evaluations
