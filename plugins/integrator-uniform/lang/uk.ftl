integrator-uniform = рівноприскорені проміжки зі сталим кроком
    .source = D 3.23
integrator-uniform-suits = рівноприскорені проміжки сталої довжини
