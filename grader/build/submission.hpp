#pragma once

// What a submission holds for a unit is a matter of the room collect.
#include "collect/handed.hpp"
#include "collect/sources.hpp"
#include "collect/submission_id.hpp"
