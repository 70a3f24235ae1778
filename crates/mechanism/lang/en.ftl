mechanism-ground = ground
