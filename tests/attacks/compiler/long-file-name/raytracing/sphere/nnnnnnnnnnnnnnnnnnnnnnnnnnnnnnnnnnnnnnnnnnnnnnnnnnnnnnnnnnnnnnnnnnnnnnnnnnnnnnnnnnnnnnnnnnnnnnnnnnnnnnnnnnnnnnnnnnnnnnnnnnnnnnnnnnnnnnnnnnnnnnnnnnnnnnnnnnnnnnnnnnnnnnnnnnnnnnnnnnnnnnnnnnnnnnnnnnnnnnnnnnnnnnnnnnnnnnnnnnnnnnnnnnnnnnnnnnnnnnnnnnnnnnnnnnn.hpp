// long
