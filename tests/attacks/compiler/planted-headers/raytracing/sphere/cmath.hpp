#error planted
