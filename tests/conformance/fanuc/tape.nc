(Ends of blocks and of the tape as manuals and listings show them.)
(SOURCE FANUC manuals, end of block ; and tape end %)
(CONTROL fanuc-16i meldas haas)

(CASE MB-008 a semicolon ends a block)
%
O1;
#100=1 ;
#101=2;#102=3;
IF[#100EQ1]GOTO10;
#103=1;
N10 G04 X0.5;
M30;
%
(EXPECT #100 = 1)
(EXPECT #101 = 2)
(EXPECT #102 = 3)
(EXPECT #103 = VACANT)

(CASE MB-008 a semicolon in a comment is text)
%
O1
#100=1 (A; B)
#3006=1(TURN; GO ON)
M30
%
(EXPECT #100 = 1)
(EXPECT STOP "TURN; GO ON")

(CASE MB-001 the tape may end on the line of the last block)
%
O1
#100=1
M30%
(EXPECT #100 = 1)
