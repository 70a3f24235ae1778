force-friction = группа за группой с сухим трением в парах, все решения
    .source = Артоболевский, Теория механизмов и машин, трение в кинематических парах; Ortega, Rheinboldt 1970, 13.1
force-friction-balance = уравновешивающая нагрузка из `[balance]`
force-friction-input = входное звено
