integrator-uniform = равноускоренные промежутки с постоянным шагом
    .source = D 3.23
integrator-uniform-suits = равноускоренные промежутки постоянной длины
