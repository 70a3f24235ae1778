# О тексте сцены, пока её строят.
draft-no-part = нет `{ $name }`
draft-name-taken = имя `{ $name }` уже занято
draft-takes-no-name = `{ $name }` не имеет имени
