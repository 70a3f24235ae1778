mechanism-ground = ground
mechanism-bracket-not-closed = a `[` is not closed
mechanism-key-continues = a key continues with `.` or `[`, not `{ $rest }`
mechanism-no-index = `[{ $index }]` is not an element: write a whole number from 0, a range such as `[1..2]`, or `[*]` for all
mechanism-quote-not-closed = a quote is not closed
mechanism-what-is-a-key = a key consists of names joined by dots, such as `link.crank.mass`
