mechanism-ground = стояк
