integrator-uniform = uniformly accelerated intervals at a fixed step
    .source = D 3.23
integrator-uniform-suits = uniformly accelerated intervals of a fixed length
