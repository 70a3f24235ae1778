integrator-dopri5 = метод Дормана–Принса 5(4), явний, адаптивний, щільний вивід порядку 4
    .source = Hairer, Nørsett, Wanner I, II.5
integrator-dopri5-suits = великий допуск: його витримують дешеві явні кроки порядку 5
integrator-dop853 = метод Дормана–Принса 8(5,3), явний, адаптивний, щільний вивід порядку 7
    .source = Hairer, Nørsett, Wanner I, II.5 і II.6
integrator-dop853-suits = малий допуск: явні кроки порядку 8 витримують його з найменшою кількістю обчислень
