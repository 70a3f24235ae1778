# Що не так із формулою.
formula-too-long = у формулі щонайбільше { $most } знаків, а тут { $count }
formula-many-signs = у формулі щонайбільше { $most } знаків дій, степенів і дужок
formula-too-deep = вкладеність формули понад { $most } рівнів
formula-ends-early = формула обривається: бракує операнда або `)`
formula-misplaced-sign = `{ $sign }` тут у формулі не місце; відомі { $known }
formula-great-number = з числом { $number } не можна обчислювати: воно завелике
formula-unknown-name = `{ $name }` у формулі невідоме; відомі { $known }
formula-arguments = `{ $name }`: аргументів має бути { $count }, а задано { $got }
formula-many-switches = у формулі щонайбільше { $most } викликів sign, step, abs, min, max і atan2
formula-foreign-sign = `{ $sign }` у формулі неприпустимо: у ній латинські літери, цифри та + - * / ^
formula-power-sign = степінь пишуть через `^`: q^2
formula-decimal-comma = кома тут — десятковий роздільник? ним має бути крапка
formula-condition = умову пишуть через `step`: step(q - 3) дорівнює 0 до q = 3 і 1 після
formula-parentheses = аргумент функції пишуть у дужках, наприклад sin(q); тут далі стоїть `{ $sign }`
formula-missing-sign = після { $number } бракує знака дії: між числом і назвою пишіть `*`; одиницю задають у `unit`
formula-meant = `{ $name }` у формулі невідоме: чи мали ви на увазі `{ $meant }`?
