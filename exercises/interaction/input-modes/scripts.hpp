#pragma once

/// What users do to the windows, in the language of input::parse_script.
namespace umbral::interaction {

/// Buttons and motion; some go down and up between two moments at which the mouse is sampled.
inline constexpr const char* sampled_hand = R"(
0.10 move 100 80
0.30 press left
0.40 move 120.5 70.25
0.60 release left
0.80 press right            # down and up between two samples
0.90 release right
1.10 press left 30 200
1.20 press middle
1.30 press right
1.40 move -15 -20.75        # outside
1.60 release left
1.70 press 5
1.80 focus off              # the window sees the buttons go up
1.90 move 200 100
2.10 press 8
2.20 move 900 700
)";

/// What happens before, during and after requests; two events of a kind at one moment.
inline constexpr const char* asked_hand = R"(
0.10 press left 10 20       # before the first request
0.20 release left
0.60 move 30 25
0.70 key A press
0.80 press right 35 28
0.80 press left
0.90 key A repeat
1.00 release right
1.10 release left
1.60 press left 50 60
1.90 move 55 61.5
2.00 move 58 59
2.10 scroll 0 -1
2.20 scroll 0.5 2
2.20 scroll 3 0
2.30 key A release
2.40 key B press
2.50 key B repeat
2.60 key B release
2.70 release left 80 90
2.80 press middle
)";

/// Every kind of event, at one moment and at several.
inline constexpr const char* queued_hand = R"(
0.10 move 100 80
0.10 press left
0.10 move 110 75.5
0.10 release left
0.20 press right 130 90
0.25 scroll 0 1
0.30 scroll -0.5 0.25
0.35 key A press
0.40 key A repeat
0.45 key A repeat
0.50 key LEFT_SHIFT press
0.55 press left
0.60 press 4 125 95
0.65 release right
0.70 move -20 -30.5
0.75 move -20.25 500
0.76 move 1234.1 768.3      # in double the change is exact
0.77 move 1234.8 769.9
0.78 move 3000.7 -1100.2
0.79 move 3001.1 -1100.6
0.80 key LEFT_SHIFT release
0.85 release left
0.90 key A release
0.95 press middle
1.00 release 4
1.05 press 8
1.10 release middle
1.15 release 8
1.20 move 0 0
)";

/// The window loses the keyboard while keys and buttons are down.
inline constexpr const char* lost_hand = R"(
0.10 press left 40 50
0.15 key W press
0.20 move 60 55
0.25 press middle
0.30 focus off
0.35 move 70 66
0.40 key W release
0.45 release left
0.50 focus on
0.55 key S press
0.60 press right 80 20
0.65 resize 0 0
0.70 resize 300 200
0.75 iconify on
0.80 release right
0.85 iconify off
0.90 key S release
)";

}
