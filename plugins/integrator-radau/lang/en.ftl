integrator-radau5 = Radau IIA of order 5, implicit, adaptive, dense output of order 3; for stiff motors
    .source = Hairer, Wanner II, IV.5 and IV.8
integrator-radau5-suits = implicit steps of order 5, which stiffness does not shorten
