int a2 = 1;
