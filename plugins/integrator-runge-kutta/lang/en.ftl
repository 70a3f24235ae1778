integrator-rk4 = classical Runge-Kutta at a fixed step
    .source = D 3.23; Kutta 1901
integrator-rk4-suits = steps of order 4 at a fixed length
