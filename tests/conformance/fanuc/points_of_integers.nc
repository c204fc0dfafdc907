(A point behind a number that counts something.)
(SOURCE M700V programming manual, decimal point input, page 28; MB-025)

(CASE MELDAS passes over it)
(CONTROL meldas mazatrol-iso)
%
O1
G10 L10 P5. R20.
G10 L12 P5. R5.
S1000. T5.
G43 H5. G00 X0 Y0 Z0
G00 G49 Z0
M98 P2. L3.
G65 P3 L2. H1.
G41 D5. G01 X10. F100.
M30
O2
#100=#100+1
M99
O3
#101=#101+#11
M99
%
(EXPECT MOVE 1 X0 Y0 Z20)
(EXPECT #100 = 3)
(EXPECT #101 = 2)

(CASE what would be lost is an alarm of ours)
(CONTROL meldas)
%
O1
G43 H1.5 Z0
M30
%
(EXPECT ALARM 33 AT 4)

(CASE nor is a thousandth of a second a second)
(CONTROL meldas)
%
O1
G04 P1.
M30
%
(EXPECT ALARM 33 AT 4)

(CASE distances and factors keep theirs)
(CONTROL meldas)
%
O1
G51 X0 Y0 Z0 P2.
G00 X10.
G50
M30
%
(EXPECT MOVE 1 X20)

(CASE elsewhere it is an alarm)
(CONTROL fanuc-16i fanuc-30i haas brother)
%
O1
G43 H5. Z0
M30
%
(EXPECT ALARM 7 AT 4)

(CASE there, too)
(CONTROL fanuc-16i fanuc-30i brother)
%
O1
M98 P2.
M30
O2
M99
%
(EXPECT ALARM 7 AT 4)
