mechanism-ground = стойка
mechanism-bracket-not-closed = `[` не закрыта
mechanism-key-continues = ключ продолжается через `.` или `[`, а не `{ $rest }`
mechanism-no-index = `[{ $index }]` не является элементом: пишите целое число от 0, диапазон, например `[1..2]`, или `[*]` для всех
mechanism-quote-not-closed = кавычка не закрыта
mechanism-what-is-a-key = ключ состоит из имён через точку, например `link.crank.mass`
