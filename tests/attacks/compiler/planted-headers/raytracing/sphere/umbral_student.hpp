#error umbral-planted
