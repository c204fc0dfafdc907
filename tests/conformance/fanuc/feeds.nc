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
