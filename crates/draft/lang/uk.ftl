# Про текст сцени, поки її будують.
draft-no-part = немає `{ $name }`
draft-name-taken = ім'я `{ $name }` вже зайняте
draft-takes-no-name = `{ $name }` не має імені
