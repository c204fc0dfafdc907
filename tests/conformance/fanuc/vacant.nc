(Vacant variables: MB-080 to MB-093.)

(CASE MB-080 vacant stays vacant in assignments)
%
O1
#1=#0
#2=#1
#100=#2
#101=5
#101=#0
#102=[#0]
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = VACANT)

(CASE MB-081 arithmetic makes it zero, a real one)
%
O1
#100=#0+1
#101=#0*10
#102=#0+#0
#103=#1*5
IF[#103EQ#0]THEN #104=1
IF[#103EQ0]THEN #105=1
#106=#0-3
#107=#0/4
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 0)
(EXPECT #102 = 0)
(EXPECT #103 = 0)
(EXPECT #104 = VACANT)
(EXPECT #105 = 1)
(EXPECT #106 = -3)
(EXPECT #107 = 0)

(CASE MB-082 a system variable cannot be vacant)
%
O1
#5221=7.5
#5221=#0
#100=#5221
IF[#5221EQ#0]THEN #101=1
IF[#5221EQ0]THEN #102=1
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = VACANT)
(EXPECT #102 = 1)

(CASE MB-083 an address with a vacant variable disappears)
%
O1
G90 G0 X100. Y#1
Y5.
#2=0
X10. Y#2
M30
%
(EXPECT MOVES 3)
(EXPECT MOVE 1 X100 Y0)
(EXPECT MOVE 2 X100 Y5)
(EXPECT MOVE 3 X10 Y0)

(CASE MB-083 so do F S T H D M and G)
%
O1
G1 F100. X1.
F#1 S#1 X2.
#100=#4109
S500 T3 M3
S#1 T#1 M#1 H#1 D#1
#101=#4119
#102=#4120
#103=#4113
G#1 X3.
#104=#4001
M30
%
(EXPECT #100 = 100)
(EXPECT #101 = 500)
(EXPECT #102 = 3)
(EXPECT #103 = 3)
(EXPECT #104 = 1)
(EXPECT MOVES 3)

(CASE MB-083 and L and R)
%
O1
G10 L2 P1 X5. Y#1
#100=#5221
#101=#5222
G81 R#1 Z-5. F100. X1. Y1.
M30
%
(EXPECT #100 = 5)
(EXPECT #101 = 0)

(CASE MB-084 a sign does not keep it)
%
O1
X5.
X-#1 Y3.
M30
%
(EXPECT MOVES 2)
(EXPECT MOVE 2 X5 Y3)

(CASE MB-085 an expression is a value)
%
O1
X[#1+10]
Y5.
X[#1+#2]
M30
%
(EXPECT MOVES 3)
(EXPECT MOVE 1 X10)
(EXPECT MOVE 3 X0 Y5)

(CASE MB-086 EQ and NE distinguish vacant from zero)
%
O1
IF[#1EQ#0]THEN #100=1
IF[0EQ#0]THEN #101=1
IF[#1NE0]THEN #102=1
IF[#1NE#0]THEN #103=1
#2=0
IF[#2EQ#0]THEN #104=1
IF[#2NE#0]THEN #105=1
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = VACANT)
(EXPECT #102 = 1)
(EXPECT #103 = VACANT)
(EXPECT #104 = VACANT)
(EXPECT #105 = 1)

(CASE MB-087 GE GT LE LT take vacant for zero)
%
O1
IF[#1GE#0]THEN #100=1
IF[#1LT5]THEN #101=1
IF[#1LT0]THEN #102=1
IF[#1LE0]THEN #103=1
IF[#1GE0]THEN #104=1
IF[#1GT0]THEN #105=1
IF[#1GT-1]THEN #106=1
IF[0GE#0]THEN #107=1
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 1)
(EXPECT #102 = VACANT)
(EXPECT #103 = 1)
(EXPECT #104 = 1)
(EXPECT #105 = VACANT)
(EXPECT #106 = 1)
(EXPECT #107 = 1)

(CASE MB-088 EQ 0 is no test for a missing argument)
%
O1
IF[#1EQ0]THEN #100=1
IF[#1EQ#0]THEN #101=1
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = 1)

(CASE MB-089 a vacant argument is not passed)
%
O1
G65 P9500 X#24 Y3.
M30
O9500
IF[#24EQ#0]THEN #100=1
#101=#25
M99
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 3)

(CASE MB-090 a vacant L is one call)
%
O1
G65 P9500 L#1
M30
O9500
#100=#100+1
M99
M30
%
(EXPECT #100 = 1)

(CASE MB-090 a vacant P is no P)
%
O1
G65 P#1
M30
%
(EXPECT ALARM 76 AT 3)

(CASE MB-090 a vacant P of M98 is no P)
%
O1
M98 P#1
M30
%
(EXPECT ALARM 76 AT 3)

(CASE MB-090 a vacant GOTO target)
(CONTROL fanuc-16i)
%
O1
GOTO #1
M30
%
(EXPECT ALARM 128 AT 4)

(CASE MB-090 a vacant GOTO target)
(CONTROL fanuc-30i)
%
O1
GOTO #1
M30
%
(EXPECT ALARM 1128 AT 4)

(CASE MB-091 DPRNT prints vacant as 0)
%
O1
POPEN
DPRNT[#100[31]]
PCLOS
M30
%
(EXPECT OUTPUT "   0.0\n")

(CASE MB-092 a vacant number of a variable is zero)
%
O1
#5=7
#100=#[#1]
#101=#[#1+5]
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = 7)

(CASE MB-093 the vacant variable cannot be set)
%
O1
#0=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-093 not even to itself or by a computed number)
%
O1
#[#1]=1
M30
%
(EXPECT ALARM 116 AT 3)
