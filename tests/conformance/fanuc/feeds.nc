(Feeds that are none.)
(SOURCE alarm 011 of the operator's manual; that less than 1e-6 is none is a bound of g31)

(CASE a feed that comes to nothing of a variable is none)
%
O1
#1=0.0001*0.0001*0.0001*0.0001
G1 X1. F#1
M30
%
(EXPECT ALARM 11 AT 4)
(EXPECT MOVES 0)

(CASE nor is one by turns)
%
O1
S1000 M3
#1=0.0001*0.0001*0.0001*0.0001
G95 G1 X1. F#1
M30
%
(EXPECT ALARM 11 AT 5)
(EXPECT MOVES 0)

(CASE nor one of a spindle whose speed comes to nothing)
%
O1
#1=0.0001*0.0001*0.0001*0.0001
S#1 M3
G95 G1 X1. F0.1
M30
%
(EXPECT ALARM 11 AT 5)
(EXPECT MOVES 0)

(CASE nor is such a lead)
%
O1
S1000 M3
#1=0.0001*0.0001*0.0001*0.0001
G33 Z-10. F#1
M30
%
(EXPECT ALARM 14 AT 5)
(EXPECT MOVES 0)

(CASE the slowest feed that goes)
%
O1
#3001=0
G1 X0.001 F0.001
#100=#3001
M30
%
(EXPECT #100 = 60000)

(CASE G95 while the spindle stands: on a control the axes wait)
%
O1
G95 S500 G1 X1. F0.1
M3
X2.
M5
X3.
M19
X4.
M30
%
(EXPECT WARNING PRB335 AT 3)
(EXPECT WARNING PRB335 AT 7)
(EXPECT WARNING PRB335 AT 9)

(CASE a skip move under G95 while the spindle stands)
(SIGNAL X5)
%
O1
S500 M5
G95 G31 X10. F0.1
M30
%
(EXPECT WARNING PRB335 AT 5)

(CASE G95 with the spindle turning, and with a code of the builder's that may turn it)
%
O1
M3 S500
G95 G1 X1. F0.1
M5
G94 X2. F100.
M8
M13
G95 X3. F0.1
M30
%
(EXPECT NO WARNING PRB335)

(CASE G33 while the spindle stands)
%
O1
S500 G33 Z-10. F1.
M30
%
(EXPECT WARNING PRB335 AT 3)

(CASE G33 while the spindle turns)
%
O1
S500 M3
G33 Z-10. F1.
M30
%
(EXPECT NO WARNING PRB335)

(CASE G95 under dry run, whose feed is per minute)
(SETTING dry_run = 2000.0)
%
O1
G95 S500 G1 X1. F0.1
M30
%
(EXPECT NO WARNING PRB335)
