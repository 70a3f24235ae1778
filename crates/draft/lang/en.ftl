# What is said of the text of a scene while it is built.
draft-no-part = there is no `{ $name }`
draft-name-taken = the name `{ $name }` is taken
draft-takes-no-name = `{ $name }` takes no name
