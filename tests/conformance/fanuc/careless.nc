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
