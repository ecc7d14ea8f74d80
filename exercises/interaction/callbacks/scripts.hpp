#pragma once

/// What is done to the windows, in the language of input::parse_script.
namespace umbral::interaction {

inline constexpr const char* orbiting = R"(
0.1 move 100 80
0.2 press left
0.3 move 101 80
0.35 move 101.0625 80
0.4 move 101 75
0.5 move 120.5 90.25
0.6 move 20 -30
0.7 release left
0.8 move 200 200        # no button is down
1.0 press left 300 210  # a press at another place than the last motion
1.1 move 303 214
1.2 release left 303 214
1.3 press left
1.4 release left
1.5 press middle
1.6 move 310 240
1.7 release middle
1.8 press 4
1.9 move 290 220
2.0 release 4
2.1 press left
2.2 key LEFT_SHIFT press     # the drag goes on as it began
2.3 move 280 225
2.4 key LEFT_SHIFT release
2.5 move 281 226
2.6 release left
)";

inline constexpr const char* panning = R"(
0.1 press right 50 60
0.2 move 70 50
0.3 move 60 45.5
0.4 release right
0.5 move 90 90
0.6 key LEFT_SHIFT press
0.7 press left
0.8 move 95 85
0.9 key LEFT_SHIFT release   # the drag goes on as it began
1.0 move 105 65
1.1 release left
1.2 press left
1.3 key RIGHT_SHIFT press    # and so does this one
1.4 move 100 70
1.5 release left
1.6 press left
1.7 move 110 71
1.8 release left
1.9 key RIGHT_SHIFT release
2.0 key LEFT_CONTROL press
2.1 press left 10 20
2.2 move 13 24
2.3 release left
2.4 key LEFT_SHIFT press     # with Control as well, Shift is down
2.5 press left
2.6 move 15 20
2.7 release left
2.8 press right
2.9 move 10 21
3.0 release right
)";

inline constexpr const char* two_buttons = R"(
0.1 press left 100 100
0.2 move 110 100
0.3 press right              # changes nothing
0.4 move 115 95
0.5 release left             # ends the drag; the right button does not take over
0.6 move 130 90
0.7 release right
0.8 move 140 80
0.9 press right
1.0 press left
1.1 move 141 70
1.2 release left
1.3 move 150 75
1.4 release right
1.5 move 160 85
1.6 press middle
1.7 press left
1.8 move 150 95
1.9 release middle
2.0 move 151 94
2.1 release left
2.2 move 1 1
)";

inline constexpr const char* outside = R"(
0.1 press left 10 10
0.2 move -0.5 -0.5           # past the upper left corner
0.3 move -300.75 -20.25
0.4 move 900 700
0.5 release left
0.6 move 320 240
0.7 press right
0.8 move 330 250
0.9 focus off                # the window sees the button go up
1.0 move 340 260
1.1 focus on
1.2 move 350 250
)";

inline constexpr const char* wheel = R"(
0.1 scroll 0 1
0.2 scroll 0 -1
0.3 scroll 0 -3
0.4 scroll 1 0
0.5 scroll -2 0
0.6 scroll 0.5 2
0.7 scroll 0 0.0625
0.8 scroll 0 -0.03125
0.9 scroll -4 -0.5
0.92 scroll 0 25
0.94 scroll 0 -24.75
0.96 scroll 0 0.0078125
1.0 press left 10 10
1.1 scroll 0 1
1.2 move 12 10
1.3 release left
)";

inline constexpr const char* keys = R"(
0.1 key R press
0.2 key R release
0.3 key 1 press
0.4 key 1 release
0.5 key 2 press
0.6 key 2 repeat
0.7 key 2 repeat
0.8 key 2 release
0.9 key 3 press
1.0 key 3 release
1.1 key 4 press
1.2 key 4 release
1.3 key 0 press
1.4 key 0 release
1.5 key LEFT_CONTROL press
1.6 key R press
1.7 key R release
1.8 key LEFT_CONTROL release
1.9 key LEFT_ALT press
2.0 key 1 press
2.1 key 1 release
2.2 key LEFT_ALT release
2.3 key LEFT_SHIFT press
2.4 key R press
2.5 key R repeat
2.6 key R release
2.7 key LEFT_SHIFT release
2.8 key A press
2.9 key A release
2.91 press left 10 10        # keys mean the same in a drag
2.92 key R press
2.93 key R release
2.94 key 2 press
2.95 key 2 release
2.96 release left
2.97 key KP_1 press          # another key than 1
2.98 key KP_1 release
3.0 key LEFT_SUPER press
3.02 key R press
3.04 key R release
3.06 key 3 press
3.08 key 3 release
3.1 key ESCAPE press
)";

inline constexpr const char* windows = R"(
0.1 resize 800 600
0.2 resize 0 0
0.3 resize 800 600
0.4 resize 300 500
0.5 resize 0 500
0.6 resize 1024 500
0.7 resize 1024 0
0.8 resize 501 333
0.9 resize 1 333
1.0 resize 640 1
)";

/// One gesture of each kind: which callbacks are there?
inline constexpr const char* each_kind = R"(
0.1 key 2 press
0.2 key 2 release
0.3 press left 10 10
0.4 move 30 20
0.5 release left
0.6 scroll 0 -1
0.7 resize 320 200
)";

/// What the picture's camera goes through.
inline constexpr const char* a_look_around = R"(
0.1 press left 60 120
0.2 move 40 125
0.3 press right
0.4 move 130 140
0.5 release left
0.6 release right
0.7 scroll 0 3
0.8 press right 10 10
0.9 move 24 27
1.0 release right
1.1 press left 128 100
1.2 move 108 109
)";

}
