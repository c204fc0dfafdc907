(Words that the machine has no use for, and programs of other machines.)
(SOURCE FANUC alarm lists, 009; MB-285)

(CASE U, V and W are axes of machines that have them)
(CONTROL fanuc-16i haas brother)
%
O1
G1 X1. U2. W-5. F100.
M30
%
(EXPECT ALARM 9 AT 4)

(CASE on MELDAS that is P32)
(CONTROL meldas)
%
O1
G0 V2.
M30
%
(EXPECT ALARM 32 AT 4)

(CASE U of a dwell is a time, U of a call an argument)
%
O1
G04 U1.5
G65 P2 U7. V8. W9.
M30
O2
#100=#21+#22+#23
M99
%
(EXPECT MOVE 1 G4 T1.5)
(EXPECT #100 = 24)

(CASE A, B and C are words of machines that have these axes)
(CONTROL fanuc-16i haas brother)
%
O1
G1 X1. F100.
X2. B90.
M30
%
(EXPECT ALARM 9 AT 5)
(EXPECT MOVES 1)

(CASE standing still is no excuse)
(CONTROL fanuc-16i)
%
O1
G0 A0.
M30
%
(EXPECT ALARM 9 AT 4)

(CASE on MELDAS it is P32)
(CONTROL meldas)
%
O1
G0 C0.
M30
%
(EXPECT ALARM 32 AT 4)

(CASE a machine with the axis takes it)
(CONTROL fanuc-16i)
(SHEET [machine.axes.C])
(SHEET travel = [-360.0, 360.0])
%
O1
G0 C90.
#100=#5026
M30
%
(EXPECT #100 = 90)

(CASE A, B and C of a macro call are arguments)
(CONTROL fanuc-16i)
%
O1
G65 P2 A1. B2. C3.
M30
O2
#100=#1+#2*10+#3*100
M99
%
(EXPECT #100 = 321)

(CASE what would take the tool elsewhere is refused)
(SOURCE FANUC 30i operator's manual B-63944EN: without the option alarm PS0010)
(CONTROL fanuc-30i)
%
O1
G0 X1.
G43.4 H1
M30
%
(EXPECT ALARM 10 AT 6)

(CASE tool offsets along the path are not simulated: G45 to G48)
(CONTROL fanuc-16i fanuc-30i fanuc-0i)
%
O1
G91 G47 G0 X10. D1
M30
%
(EXPECT ALARM 10 AT 4)

(CASE G39 of cutter compensation is not simulated)
(CONTROL fanuc-16i fanuc-30i fanuc-0i)
%
O1
G39 X1. Y2.
M30
%
(EXPECT ALARM 10 AT 4)
