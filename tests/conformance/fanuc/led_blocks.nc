(What stands beside a tilted plane, cutter compensation in it, and G68 in space.)
(SOURCE FANUC B-62764EN/01 p. 243, B-63664EN p. 392; each place by hand)
(CONTROL fanuc-30i meldas)
(SHEET [machine])
(SHEET table_side = "CA")
(SHEET tool_side = "XYZ")
(SHEET [machine.axes.A])
(SHEET travel = [-120.0, 120.0])
(SHEET centre = [0.0, 20.0, -450.0])
(SHEET [machine.axes.C])
(SHEET travel = [-36000.0, 36000.0])
(SHEET centre = [5.0, -3.0, 0.0])
(SHEET [work_offsets.G54])
(SHEET X = 40.0)
(SHEET Y = -25.0)
(SHEET Z = -380.0)
(SHEET [tools.1])
(SHEET length = 120.0)

(SHEET radius = 3.0)
(SHEET [tools.2])
(SHEET length = 87.5)

(CASE a block that waits goes as the offsets were when it was written)
%
O1
G90 G54 G43 H1 Z10.
G68.2 X0 Y0 Z0 I0 J0 K0
G0 X0 Y0 Z0
G41 D1 G1 X5. F500.
X10.
Y10.
G43 H2 X0
G40 X-5.
M30
%
(EXPECT MOVE 4 X47 Y-22 Z-260)
(EXPECT MOVE 5 X47 Y-18 Z-260)
(EXPECT MOVE 6 X40 Y-18 Z-292.5)

(CASE as it does without a plane)
%
O1
G90 G54 G43 H1 Z10.
G0 X0 Y0 Z0
G41 D1 G1 X5. F500.
X10.
Y10.
G43 H2 X0
G40 X-5.
M30
%
(EXPECT MOVE 4 X47 Y-22 Z-260)
(EXPECT MOVE 5 X47 Y-18 Z-260)
(EXPECT MOVE 6 X40 Y-18 Z-292.5)

(CASE a plane does not end while its coordinates are compensated in)
(CONTROL fanuc-30i)
%
O1
G90 G54 G43 H1 Z10.
G68.2 X10. Y20. Z5. I30. J20. K10.
G53.1
G0 X1. Y2. Z3.
G41 D1 G1 X5. F500.
X10.
Y10.
G69
M30
%
(EXPECT ALARM 35 AT 11)

(CASE nor turns the tool)
(CONTROL fanuc-30i)
%
O1
G90 G54 G43 H1 Z10.
G68.2 X10. Y20. Z5. I30. J20. K10.
G0 X1. Y2. Z3.
G41 D1 G1 X5. F500.
X10.
G53.1
M30
%
(EXPECT ALARM 35 AT 9)

(CASE while an offset is left)
(CONTROL fanuc-30i)
%
O1
G90 G54
G68.2 X0 Y0 Z0 I0 J0 K0
G0 X0 Y0 Z0
G41 D1 G1 X5. F500.
X10.
G40 Z5.
G69
M30
%
(EXPECT ALARM 35 AT 10)

(CASE where none ever was)
(CONTROL fanuc-30i)
%
O1
G90 G54
G68.2 X0 Y0 Z0 I0 J0 K0
G0 X0 Y0 Z0
G41 D0 G1 X5. F500.
X10.
G69
M30
%
(EXPECT MOVE 3 X50 Y-25)

(CASE behind G40 it ends)
%
O1
G90 G54
G68.2 X0 Y0 Z0 I0 J0 K0
G0 X0 Y0 Z0
G41 D1 G1 X5. F500.
X10.
G40 X15.
G69
X0
M30
%
(EXPECT NO WARNING PRB328)

(CASE an arc, where G54.4 tilts the part and nothing leads the axes)
(CONTROL fanuc-30i)
%
O1
#26013=.5
G54.4 P1
G0 X50. Y0
G3 X-50. Y0 I-50. F1000.
M30
%
(EXPECT ALARM 113 AT 7)

(CASE compensation there)
(CONTROL fanuc-30i)
%
O1
#26013=.5
G54.4 P1
G0 X50. Y0
G41 D1 G1 X40. F1000.
M30
%
(EXPECT ALARM 113 AT 7)

(CASE a tilt that nobody sees)
(CONTROL fanuc-30i)
%
O1
#26013=.00001
G54.4 P1
G0 X50. Y0
G3 X0 Y50. I-50. F1000.
#100=#5002
M30
%
(EXPECT #100 = 50)

(CASE an arc follows where the part is turned in its plane)
(CONTROL fanuc-30i)
%
O1
#26015=90.
G54.4 P1
G0 X10. Y0
G3 X0 Y10. R10. F1000.
M30
%
(EXPECT MOVE 2 X30 Y-25)

(CASE no other code takes the words of G68.2)
(CONTROL fanuc-30i)
%
O1
G68.2 X10. Y0 Z0 I0 J10. K0 G53.1
M30
%
(EXPECT ALARM 5458 AT 4)

(CASE and words that it has no use for are told)
%
O1
G68.2 X10. Y0 Z0 R30.
M30
%
(EXPECT WARNING PRB328 AT 3)

(CASE so are those of G53.1)
%
O1
G68.2 X10. Y0 Z0 I0 J10. K0
G53.1 X5.
M30
%
(EXPECT WARNING PRB328 AT 4)

(CASE G68 with I J K turns space about a line)
%
O1
G90 G54 G0 X0 Y0 Z0
G68 X10. Y5. Z3. I1. J0 K0 R30.
G0 X0 Y20. Z0
#100=#5002
#101=#4016
G69
#102=#5002
M30
%
(EXPECT MOVE 2 X40 Y-5.509619 Z-372.098076)
(EXPECT #100 = 20)
(EXPECT #101 = 68)
(EXPECT #102 = 19.490381 WITHIN 0.000001)

(CASE about Z it is the rotation of the plane, which the length of the direction does not matter for)
%
O1
G90 G54 G0 X0 Y0 Z0
G68 X10. Y5. Z0 I0 J0 K2. R30.
G0 X20. Y5.
G69
M30
%
(EXPECT MOVE 2 X58.660254 Y-15 Z-380)

(CASE what is not named is where the tool is)
%
O1
G90 G54 G0 X10. Y5. Z3.
G68 I1. J0 K0 R30.
G0 X0 Y20. Z0
M30
%
(EXPECT MOVE 2 X40 Y-5.509619 Z-372.098076)

(CASE the angle has to be said)
(CONTROL fanuc-30i)
%
O1
G68 X10. Y5. Z3. I1. J0 K0
M30
%
(EXPECT ALARM 5044 AT 4)

(CASE and all of its direction)
(CONTROL fanuc-30i)
%
O1
G68 X10. Y5. Z3. I1. R30.
M30
%
(EXPECT ALARM 5044 AT 4)

(CASE a second one turns in the first, about its centre where it names none: Z by 90, then the new X)
(CONTROL fanuc-30i)
%
O1
G90 G54 G0 X0 Y0 Z0
G68 X10. Y0 Z0 I0 J0 K1. R90.
G68 I1. J0 K0 R90.
G0 X10. Y5. Z0
G69
M30
%
(EXPECT MOVE 2 X50 Y-25 Z-375)

(CASE G68.2 does not take its place)
(CONTROL fanuc-30i)
%
O1
G68 X0 Y0 Z0 I0 J0 K1. R90.
G68.2 X0 Y0 Z0 I0 J0 K0
M30
%
(EXPECT ALARM 5458 AT 5)

(CASE nor does a tool turn to it)
(CONTROL fanuc-30i)
%
O1
G68 X0 Y0 Z0 I1. J0 K0 R30.
G53.1
M30
%
(EXPECT ALARM 5461 AT 5)

(CASE a Haas turns planes alone)
(CONTROL haas)
%
O1
G68 X0 Y0 I1. R90.
G0 X10. Y0
M30
%
(EXPECT WARNING PRB328 AT 4)
(EXPECT MOVE 1 X40 Y-15)
