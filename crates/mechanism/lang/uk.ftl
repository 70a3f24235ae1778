mechanism-ground = стояк
mechanism-bracket-not-closed = `[` не закрито
mechanism-key-continues = ключ продовжується через `.` або `[`, а не `{ $rest }`
mechanism-no-index = `[{ $index }]` не є елементом: пишіть ціле число від 0, діапазон, наприклад `[1..2]`, або `[*]` для всіх
mechanism-quote-not-closed = лапку не закрито
mechanism-what-is-a-key = ключ складається з імен через крапку, наприклад `link.crank.mass`
