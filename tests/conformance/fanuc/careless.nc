(SOURCE what a control takes without a word, though the program cannot mean it: each is told, and what is)
(SOURCE done with care is not)

(CASE CL-01 the skip position before any skip move is that of another program)
%
O1
#1=#5061
M30
%
(EXPECT WARNING PRB319 AT 3)

(CASE CL-02 after a skip move it is of this one)
(SIGNAL X20)
%
O1
G31 X50. F100.
IF[#5061GT40.]GOTO1
N1 M30
%
(EXPECT NO WARNING PRB319)

(CASE CL-03 G31 P98 latches its end without any signal)
%
O1
G31 P98 X10. F100.
#1=#5061
M30
%
(EXPECT #1 = 10)
(EXPECT WARNING PRB304 AT 3)
(EXPECT NO WARNING PRB319)

(CASE CL-04 a jump into a loop goes round its condition)
(SOURCE MB-183: not checked on most controls)
%
O1
#1=7
GOTO10
WHILE[#1LT3]DO1
N10 #2=#1
END1
M30
%
(EXPECT #2 = 7)
(EXPECT WARNING PRB322 AT 5)

(CASE CL-05 IF and a computed number jump into it as well)
%
O1
#1=7
#3=20
IF[#1EQ7]GOTO10
WHILE[#1LT3]DO1
N10 #2=1
END1
GOTO#3
WHILE[#1LT3]DO1
WHILE[#1LT3]DO2
N20 #4=1
END2
END1
M30
%
(EXPECT #4 = 1)
(EXPECT WARNING PRB322 AT 5)
(EXPECT WARNING PRB322 AT 9)

(CASE CL-06 a jump to the WHILE itself, within the loop and out of it is none into it)
%
O1
#1=0
GOTO5
#1=100
N5 WHILE[#1LT3]DO1
#1=#1+1
IF[#1EQ1]GOTO6
GOTO7
N6 #2=1
N7 IF[#1EQ2]GOTO8
END1
N8 M30
%
(EXPECT #1 = 2)
(EXPECT NO WARNING PRB322)

(CASE CL-07 from one loop into another beside it)
%
O1
#1=0
WHILE[#1LT3]DO1
#1=#1+1
GOTO5
END1
WHILE[#1LT3]DO1
N5 #2=#1
#1=9
END1
M30
%
(EXPECT #2 = 1)
(EXPECT WARNING PRB322 AT 6)

(CASE CL-08 DPRNT without room for the highest digits)
(SOURCE MB-243: they are lost)
%
O1
POPEN
#100=123456.7
DPRNT[X#100[33]]
PCLOS
M30
%
(EXPECT WARNING PRB323 AT 6)

(CASE CL-09 DPRNT with room for them, and a zero before the point that no place is for)
%
O1
POPEN
#100=999.9994
#101=-0.456
DPRNT[X#100[33]Y#101[2]]
PCLOS
M30
%
(EXPECT NO WARNING PRB323)

(CASE CL-10 rounding makes one digit more)
%
O1
POPEN
#100=999.9996
DPRNT[X#100[33]]
PCLOS
M30
%
(EXPECT WARNING PRB323 AT 5)

(CASE CL-11 M6 before any T is a note)
%
O1
M6
M30
%
(EXPECT WARNING PRB324 AT 3)

(CASE CL-12 T in an earlier block, or in the same)
%
O1
T1
M6
T2 M6
M30
%
(EXPECT NO WARNING PRB324)

(CASE CL-13 I J K of G51 count only with parameter 5400.6)
%
O1
G51 X0 Y0 I2000 J2000
G0 X10.
G50
M30
%
(EXPECT MOVE 1 X10)
(EXPECT WARNING PRB328 AT 3)

(CASE CL-14 with it they do)
(PARAMETER 5400.6 = 1)
%
O1
G51 X0 Y0 I2000 J2000
G0 X10.
G50
M30
%
(EXPECT MOVE 1 X20)
(EXPECT NO WARNING PRB328)

(CASE CL-15 L repeats a canned cycle with parameter 0001.1 only)
%
O1
G81 X5. Z-5. R2. L3 F100.
G80
M30
%
(EXPECT WARNING PRB328 AT 3)

(CASE CL-16 a cycle needs R and Z in its first block)
%
O1
G0 Z10.
G81 X5. Z-5. F100.
G80
M30
%
(EXPECT WARNING PRB329 AT 4)

(CASE CL-17 and only there)
%
O1
G81 X5. Z-5. R2. F100.
X10.
G80
G81 X5. R2. Z-5.
G80
M30
%
(EXPECT NO WARNING PRB329)

(CASE CL-18 the second cycle asks again)
%
O1
G81 X5. Z-5. R2. F100.
G80
G81 X5. R2.
G80
M30
%
(EXPECT WARNING PRB329 AT 5)

(CASE CL-19 an axis word before G65 is an argument and moves nothing)
%
O1
X5. G65 P9500 A1.
#101=#5041
M30
O9500
#100=#24
M99
%
(EXPECT #100 = 5)
(EXPECT #101 = 0)
(EXPECT WARNING PRB330 AT 3)

(CASE CL-20 behind it is where arguments belong)
%
O1
G65 X5. P9500 A1.
M30
O9500
M99
%
(EXPECT NO WARNING PRB330)

(CASE CL-21 other origins and reference points while G68 turns the coordinates)
%
O1
G90 G54 G00 X0. Y0.
G68 X0. Y0. R30.
X10.
G55
G28 X10. Y0.
G69
G54
G28 Z0.
M30
%
(EXPECT WARNING PRB332 AT 6)
(EXPECT WARNING PRB332 AT 7)

(CASE CL-22 behind G69, or with G68 itself, they have their place)
%
O1
G90 G54 G68 X0. Y0. R30.
G00 X10.
G69 G55
G68 X0. Y0. R10.
G54 G69
G28 Z0.
M30
%
(EXPECT NO WARNING PRB332)

(CASE CL-23 each skip move in a turned plane is told of)
(SIGNAL X20)
%
O1
G90 G54 G00 X0. Y0.
G68 X0. Y0. R30.
G31 X50. F100.
#1=#5061
G01 X0. Y0. F500.
G31 X40. F100.
#2=#5061
G69
M30
%
(EXPECT WARNING PRB303 AT 6)
(EXPECT WARNING PRB303 AT 9)

(CASE G43 without H, and none before it)
%
O1
G90 G43 Z50.
M30
%
(EXPECT WARNING PRB328 AT 3)

(CASE G41 without D, and none before it)
%
O1
G90 G0 X0 Y0
G1 G41 X10. F100.
G40 X0
M30
%
(EXPECT WARNING PRB328 AT 4)

(CASE G43 and G41 with H0 and D0, and with those of before)
(SHEET [tools.1])
(SHEET length = 100.0)
(SHEET radius = 3.0)
%
O1
G90 G43 H0 Z300.
G1 G41 D0 X10. F100.
X20.
G40 X0
G49 H1
G43 Z200.
G0 Y5. D1
G1 G41 X10. F100.
G40 X0
M30
%
(EXPECT NO WARNING PRB328)

(CASE G02 and G03 without R and without a centre go straight)
(SOURCE MB-305)
%
O1
G1 X10. F500.
G2 X20. Y10.
G18 G3 X30.
M30
%
(EXPECT MOVE 2 G1 X20 Y10)
(EXPECT WARNING PRB336 AT 5)
(EXPECT MOVE 3 G1 X30 Y10)
(EXPECT WARNING PRB336 AT 6)

(CASE arcs with R or with one coordinate of the centre, and a full circle)
%
O1
G1 X10. F500.
G2 X20. Y10. R10.
G3 X30. Y20. J10.
G3 I5.
M30
%
(EXPECT NO WARNING PRB336)

(CASE an axis beside G04 neither moves nor waits)
%
O1
G04 Y5.
M30
%
(EXPECT WARNING PRB328 AT 3)

(CASE G04 alone, with its time, or with codes)
%
O1
G04
G04 X1.
G04 P500
G04 X1. M8
M30
%
(EXPECT NO WARNING PRB328)
