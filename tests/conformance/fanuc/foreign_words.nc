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
