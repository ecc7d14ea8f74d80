#include "calibrate/explanations.hpp"
