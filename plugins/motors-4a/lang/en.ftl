motors-4a = series 4A, closed (IP44), 0.06-90 kW, 2-8 poles; no rotor inertia
    .source = GOST 19523, as reprinted in textbooks on machine elements
