{ global: *; };
