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

(CASE variables as a control punches them are doubles, what is none is vacant)
(SOURCE files MACRO.TXT of FANUC 30i and 0i-F)
(CONTROL fanuc-30i)
%
G10L85P500(4008000000000000)
G10L85P501(BFF8000000000000)
G10L85P502(FFFFFFFFFFFFFFFF)
G10L85P503(0000000000000000)
SETVN500[BALL]
SETVN501[]
#100=[#BALL]+1
M02
%
(EXPECT #500 = 3)
(EXPECT #501 = -1.5)
(EXPECT #502 = VACANT)
(EXPECT #503 = 0)
(EXPECT #100 = 4)

(CASE which have 16 hexadecimal digits)
(CONTROL fanuc-30i)
%
O1
G10L85P500(40080000)
M30
%
(EXPECT ALARM 1144 AT 4)

(CASE folders before the programs that lie in them)
(SOURCE files ALL-FLDR.TXT of FANUC 30i and 0i-F)
(CONTROL fanuc-30i)
%
&F=//CNC_MEM/
&F=/USER/PATH1/
O0001(MAIN)
G0 X1.
M98 P2
M30
&F=/USER/LIBRARY/
O0002(SUB)
#500=7
M99
%
(EXPECT MOVE 1 G0 X1)
(EXPECT #500 = 7)

(CASE other lines that begin so are none)
(CONTROL fanuc-30i)
%
O1
&X=1
M30
%
(EXPECT ALARM 4 AT 4)
