(What a control that reads ahead sees: MB-160 to MB-167.)

(CASE MB-164 a work position behind a move needs a fence)
(SETTING lookahead = 1)
%
O1
G0 X1.
#100=#5041
M30
%
(EXPECT WARNING PRB305 AT 5)
(EXPECT #100 = 1)

(CASE MB-161 G53 is one)
(SETTING lookahead = 1)
%
O1
G0 X1.
G53
#100=#5041
M30
%
(EXPECT NO WARNING PRB305)
(EXPECT #100 = 1)

(CASE MB-164 and #5061 is safe)
(SETTING lookahead = 1)
(SIGNAL X2)
%
O1
G31 X5. F100.
#100=#5061
M30
%
(EXPECT #100 = 2)
(EXPECT NO WARNING PRB305)

(CASE MB-160 without reading ahead each block waits)
%
O1
G0 X5.
#100=#5041
#101=#5021
M30
%
(EXPECT #100 = 5)
(EXPECT #101 = 5)

(CASE MB-161 MB-280 G31 without an axis is one, needs no feed and measures nothing)
(SETTING lookahead = 1)
%
O1
G01
G31
G0 X1.
G31
#100=#5041
#101=#5061
M30
%
(EXPECT MOVE 1 G0 X1)
(EXPECT #100 = 1)
(EXPECT #101 = 0)
(EXPECT NO WARNING PRB305)
(EXPECT NO WARNING PRB301)

(CASE MB-161 MB-291 so does G53 without an axis, whatever feed group 01 would need)
(SETTING lookahead = 1)
%
O1
G01
G53
G0 X1.
G53
#100=#5041
M30
%
(EXPECT MOVE 1 G0 X1)
(EXPECT #100 = 1)
(EXPECT NO WARNING PRB305)
