(Codes that MELDAS and Brother have, and that g31 does not simulate.)
(SOURCE M700V programming manual, circle cutting, page 380; C00 NC programming manual)

(CASE circle cutting ends where it begins)
(CONTROL meldas mazatrol-iso brother)
%
O1
G00 X10. Y20.
G12 I15. D1 F100.
#100=#5001
#101=#5002
M30
%
(EXPECT WARNING PRB304 AT 5)
(EXPECT MOVES 1)
(EXPECT #100 = 10)
(EXPECT #101 = 20)

(CASE what would leave the tool elsewhere is an alarm)
(CONTROL meldas)
%
O1
G30.1 Z0
M30
%
(EXPECT ALARM 34 AT 4)

(CASE so is a tilted plane)
(CONTROL brother)
%
O1
G68.2 X0 Y0 Z0 I0 J0 K0
M30
%
(EXPECT ALARM 10 AT 4)
