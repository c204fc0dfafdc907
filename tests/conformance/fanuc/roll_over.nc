(Rotary axes that go round: parameter 1008.)
(SOURCE FANUC 16i-MA operator's manual B-63534EN/02, 20.2.1, its table of movements, and 20.2.2; 15i connection manual B-63783EN-1/01, 1.6.3)
(CONTROL fanuc-16i fanuc-30i fanuc-0i)
(SHEET [machine.axes.A])
(SHEET travel = [-3600.0, 3600.0])
(SHEET [machine.axes.C])
(SHEET travel = [-3600.0, 3600.0])

(CASE the table of the manual)
(PARAMETER 1008.0 = 1)
%
O1
G90 G0 A0
A-150.
#101=#5004
A540.
#102=#5044
A-620.
#103=#5024
G91 A380.
#104=#5004
A-840.
#105=#5004
M30
%
(EXPECT MOVE 2 A-150)
(EXPECT #101 = 210)
(EXPECT MOVE 3 A-180)
(EXPECT #102 = 180)
(EXPECT MOVE 4 A-260)
(EXPECT #103 = 100)
(EXPECT MOVE 5 A120)
(EXPECT #104 = 120)
(EXPECT MOVE 6 A-720)
(EXPECT #105 = 0)

(CASE without it values are as written)
%
O1
G90 G0 A-150.
A540.
#102=#5044
M30
%
(EXPECT MOVE 2 A540)
(EXPECT #102 = 540)

(CASE half a turn goes the positive way)
(PARAMETER 1008.0 = 1)
%
O1
G90 G0 A-180.
M30
%
(EXPECT MOVE 1 A180)

(CASE RAB: the sign is the direction, the rest the place)
(PARAMETER 1008.0 = 1)
(PARAMETER 1008.1 = 1)
%
O1
G90 G0 A10.
A-350.
A350.
A-350.
M30
%
(EXPECT MOVE 1 A10)
(EXPECT MOVE 2 A-10)
(EXPECT MOVE 3 A-10)

(CASE one axis alone, by digits of its own)
(PARAMETER 1008.C = 1)
%
O1
G90 G0 A270. C270.
#100=#5006
M30
%
(EXPECT MOVE 1 A270 C-90)

(CASE G10 L52 sets it as the sheet does)
(CONTROL fanuc-30i)
%
O1
G10 L52
N1008 R00000001
G11
G90 G0 A270.
M30
%
(EXPECT MOVE 1 A-90)

(CASE work offsets and G53: machine coordinates go round, too)
(PARAMETER 1008.0 = 1)
%
O1
G10 L2 P1 A90.
G90 G54 G0 A300.
#100=#5024
G53 A350.
#101=#5004
M30
%
(EXPECT MOVE 1 A30)
(EXPECT #100 = 30)
(EXPECT MOVE 2 A-10)
(EXPECT #101 = 260)

(CASE the way home is no longer than half a turn)
(PARAMETER 1008.0 = 1)
%
O1
G91 G0 A1000.
G28 A0
#100=#5024
G27 A0
M30
%
(EXPECT MOVE 3 A1080)
(EXPECT #100 = 0)

(CASE a skip position is shown within the turn)
(PARAMETER 1008.0 = 1)
(SIGNAL A400)
%
O1
G91 G31 A500. F100.
#100=#5064
M30
%
(EXPECT #100 = 40)
