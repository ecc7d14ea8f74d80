int a3 = 1;
