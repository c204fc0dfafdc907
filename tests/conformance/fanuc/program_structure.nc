(How a tape is read: MB-001 to MB-016.)

(CASE MB-001 what stands behind the last percent sign is no program)
%
O0001
#100=1
M30
%
#100=2
(EXPECT #100 = 1)

(CASE MB-001 what follows the percent sign in its line is leader too)
% PROBE 7
O0001
#100=1
M30
%
(EXPECT #100 = 1)

(CASE MB-002 a colon in place of O)
%
:0012
#100=#4115
M30
%
(EXPECT #100 = 12)

(CASE MB-002 without O the first N number names the program)
%
N0020 #100=7
M30
%
(EXPECT #100 = 7)

(CASE MB-002 eight digits of a program number)
(CONTROL fanuc-30i)
%
O12345678
#100=1
M30
%
(EXPECT #100 = 1)

(CASE MB-002 a program with a name)
(CONTROL fanuc-30i)
%
<PROBE-BORE>
#100=1
M30
%
(EXPECT #100 = 1)

(CASE MB-003 sequence numbers in any order with gaps)
%
O1
N300 #100=1
N20 #101=2
GOTO 7
#102=3
N7 #103=4
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 2)
(EXPECT #102 = VACANT)
(EXPECT #103 = 4)

(CASE MB-003 five digits)
%
O1
GOTO 99999
#100=1
N99999 #101=2
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = 2)

(CASE MB-003 eight digits on the 30i)
(CONTROL fanuc-30i)
%
O1
GOTO 12345678
#100=1
N12345678 #101=2
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = 2)

(CASE MB-004 leading zeros do not matter)
%
O0001
G0090 G0001 X0010. F0100.
#0100=#00004001
GOTO 0010
#101=1
N010 #102=#4003
M0030
%
(EXPECT #100 = 1)
(EXPECT #101 = VACANT)
(EXPECT #102 = 90)
(EXPECT MOVE 1 G1 X10)

(CASE MB-004 a zero in place of the letter O is rejected)
(CONTROL fanuc-16i)
%
O0001
#100=1
01000
M30
%
(EXPECT ALARM FORMAT AT 5)

(CASE MB-004 the letter O inside a variable number)
(CONTROL fanuc-16i)
%
O0001
#1O0=1
M30
%
(EXPECT ALARM FORMAT AT 4)

(CASE MB-005 block skip of one switch leaves the others)
(SETTING block_skip = [2])
%
O1
/#100=1
/1#101=1
/2#102=1
/3#103=1
/9#104=1
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 1)
(EXPECT #102 = VACANT)
(EXPECT #103 = 1)
(EXPECT #104 = 1)

(CASE MB-005 slash alone is switch 1)
(SETTING block_skip = [1])
%
O1
/#100=1
/1#101=1
/2#102=1
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = VACANT)
(EXPECT #102 = 1)

(CASE MB-006 a slash inside an expression divides)
(SETTING block_skip = [1])
%
O1
#100=12/4
G0 X[12/4]
M30
%
(EXPECT #100 = 3)
(EXPECT MOVE 1 X3)

(CASE MB-007 the first closing parenthesis ends a comment)
%
O1
#100=1(A(B)
#101=2
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 2)

(CASE MB-007 parentheses do not group)
(CONTROL fanuc-16i)
%
O1
#100=2*(3+4)
M30
%
(EXPECT ALARM FORMAT AT 4)

(CASE MB-007 a comment between words does nothing)
%
O1
G0 (RAPID) X5. (TO THE PART) Y2.
N10 (LABEL) #100=#5001
M30
%
(EXPECT #100 = 5)
(EXPECT MOVE 1 G0 X5 Y2)

(CASE MB-008 blanks mean nothing)
%
O 1
I F [ # 1 0 0 E Q # 0 ] G O T O 1 0
#101=9
N 1 0 # 1 0 2 = 1 2 . 5
G 0 X 1 . 2 5
M 3 0
%
(EXPECT #101 = VACANT)
(EXPECT #102 = 12.5)
(EXPECT MOVE 1 G0 X1.25)

(CASE MB-008 and without blanks it is the same)
%
O1
IF[#100EQ#0]GOTO10
#101=9
N10#102=12.5
G0X1.25
M30
%
(EXPECT #101 = VACANT)
(EXPECT #102 = 12.5)
(EXPECT MOVE 1 G0 X1.25)

(CASE MB-011 a macro statement and NC words in one block)
%
O1
#100=1 G0 X1.
M30
%
(EXPECT ALARM 127 AT 3)

(CASE MB-011 NC words before a macro statement)
%
O1
G0 X1. #100=1
M30
%
(EXPECT ALARM 127 AT 3)

(CASE MB-011 a GOTO behind NC words)
%
O1
G0 X1. GOTO 5
N5 M30
%
(EXPECT ALARM 127 AT 3)

(CASE MB-013 M02 ends the program too)
%
O1
#100=1
M02
#100=2
M30
%
(EXPECT #100 = 1)

(CASE MB-013 running off the end)
(CONTROL fanuc-16i)
%
O1
#500=1
%
(EXPECT ALARM 5010)
(EXPECT #500 = 1)

(CASE MB-014 the last G code of a group and the last word of an address count)
%
O1
G0 G1 X1. X3. F100. F200.
#100=#4001
#101=#4109
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 200)
(EXPECT MOVE 1 G1 X3)

(CASE MB-014 parameter 3403.6 makes an address twice an alarm)
(PARAMETER 3403.6 = 1)
%
O1
G0 X1. X3.
M30
%
(EXPECT ALARM 5074 AT 4)

(CASE MB-015 the order of words is free)
%
O1
F250. Y2. X1. G1 G90
#100=#4109
M30
%
(EXPECT MOVE 1 G1 X1 Y2)
(EXPECT #100 = 250)

(CASE MB-016 N before and behind the slash; a skipped block is a target all the same)
(SETTING block_skip = [1, 2])
%
O1
GOTO 10
#100=1
/N10 #101=1
#102=1
GOTO 20
#103=1
N20 /2 #104=1
#105=1
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = VACANT)
(EXPECT #102 = 1)
(EXPECT #103 = VACANT)
(EXPECT #104 = VACANT)
(EXPECT #105 = 1)

(CASE MB-006 a slash in the middle of a block: its switch is off)
(SETTING block_skip = [1])
%
O1
G0 X1. /2 Y2.
M30
%
(EXPECT MOVES 1)
(EXPECT MOVE 1 G0 X1 Y2)
(EXPECT WARNING PRB307 AT 4)

(CASE MB-006 and on: the rest of the block is skipped)
(SETTING block_skip = [2])
%
O1
G0 X1. /2 Y2. M98 P99
M30
%
(EXPECT MOVES 1)
(EXPECT MOVE 1 G0 X1 Y0)

(CASE MB-005 switches 2 to 9 at the head of a block, with and without N)
(SETTING block_skip = [2, 9])
%
O1
/1#101=1
/2#102=1
N30/3#103=1
/9N40#109=1
/2/3#104=1
M30
%
(EXPECT #101 = 1)
(EXPECT #102 = VACANT)
(EXPECT #103 = 1)
(EXPECT #109 = VACANT)

(CASE the end stands among other M codes)
(CONTROL fanuc-30i)
%
O1
#101=1
M30 M05
#101=2
%
(EXPECT #101 = 1)
(EXPECT COMPLETED)

(CASE so does a stop)
(CONTROL fanuc-30i)
%
O1
M00 M05
M30
%
(EXPECT STOP "")
