mechanism-ground = стойка
