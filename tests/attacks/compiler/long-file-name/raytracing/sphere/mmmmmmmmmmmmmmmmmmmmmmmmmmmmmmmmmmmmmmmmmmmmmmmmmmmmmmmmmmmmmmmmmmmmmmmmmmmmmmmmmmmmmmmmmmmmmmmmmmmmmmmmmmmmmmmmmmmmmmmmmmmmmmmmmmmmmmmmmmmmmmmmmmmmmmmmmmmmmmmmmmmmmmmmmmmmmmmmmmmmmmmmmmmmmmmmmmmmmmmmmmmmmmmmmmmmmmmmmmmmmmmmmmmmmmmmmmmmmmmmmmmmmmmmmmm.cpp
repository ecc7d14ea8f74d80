int of_a_long_name = 1;
