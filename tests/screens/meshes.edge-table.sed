# The marks that tell which neighbours were seen begin with 0, which is a vertex too.
s/last_reached_from(count, count);/last_reached_from(count, 0);/
