integrator-radau5 = метод Радо IIA порядку 5, неявний, адаптивний, щільний вивід порядку 3; для жорстких двигунів
    .source = Hairer, Wanner II, IV.5 і IV.8
integrator-radau5-suits = неявні кроки порядку 5, які жорсткість не вкорочує
