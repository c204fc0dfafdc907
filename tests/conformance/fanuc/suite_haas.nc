(A suite in the habits of Haas shops, on true parts: settings asked first, M97 for what repeats, G103,)
(#10000 and on, IF with M98 and with plain assignments, M79, G154, DPRNT, a tool offset of 100.)
(SOURCE sizes of the parts: a block of 60 by 40 mm whose middle stands at 0.25 and -0.1)
(CONTROL haas)
(SET #20009 = 1)
(START X = 200)
(START Y = 100)
(SHEET [tools.10])
(SHEET length = 100.0)
(SHEET [work_offsets."G154 P2"])
(SHEET X = 200.0)
(SHEET Y = 100.0)
(SHEET Z = -250.0)
(SHEET [probe])
(SHEET ball_diameter = 6.0)
(SHEET length = 100.0)
(SHEET [[part]])
(SHEET shape = "block")
(SHEET at = [200.25, 99.9, -250.0])

(CASE the middle of a block by four touches, one local subprogram for all)
%
O02001 (VICE CENTRE)
G00 G17 G40 G49 G80 G90
IF [ #20009 NE 1 ] #3000= 10 (SETTING 9 IS NOT MM)
T10 M06
IF [ #3026 NE 10 ] #3000= 11 (NO PROBE)
G103 P1
G187 P2
G154 P2
G00 X0. Y0.
G43 H10 Z30.
#10000= 3. (BALL RADIUS)
#10001= 10. (CLEARANCE)
#10002= 0. (WHICH SIDE)
M97 P1000 L2
G00 X0. Y0.
#10150= [ #10100 + #10101 ] / 2.
#10151= [ #10102 + #10103 ] / 2.
#10152= #10100 - #10101 - 2. * #10000
#10153= #10102 - #10103 - 2. * #10000
IF [ [ ABS[ #10152 - 60. ] LT 0.01 ] AND [ ABS[ #10153 - 40. ] LT 0.01 ] ] #10160= 1
IF [ #10160 ] M98 P2002
G04 P0.5
G53 G00 Z0.
G49
G53 X0. Y0.
M30
N1000 (BOTH ENDS OF ONE AXIS)
M97 P1100
M97 P1100
#10002= #10002 + 1.
M99
N1100 (ONE SIDE)
#1= 1.
IF [ #10003 ] #1= -1.
#2= 1. - #10002
#3= #10002
#4= 30. * #2 + 20. * #3 + #10001
G00 X[ #1 * #4 * #2 ] Y[ #1 * #4 * #3 ]
G31 Z-6. F1500. M78
G91 G31 X[ - #1 * #2 * 13. ] Y[ - #1 * #3 * 13. ] F100. M79
G90
#[ 10100 + #10002 * 2. + #10003 ]= #5061 * #2 + #5062 * #3
G00 X[ #1 * #4 * #2 ] Y[ #1 * #4 * #3 ]
G00 Z30.
#10003= 1. - #10003
M99
O02002 (WORK OFFSET AND REPORT)
#14021= #14021 + #10150
#14022= #14022 + #10151
POPEN
DPRNT[X#10150[23]*Y#10151[23]]
PCLOS
M99
%
(EXPECT #150 = 0.25 WITHIN 0.0001)
(EXPECT #151 = -0.1 WITHIN 0.0001)
(EXPECT #10152 = 60 WITHIN 0.0001)
(EXPECT #10153 = 40 WITHIN 0.0001)
(EXPECT #7021 = 200.25 WITHIN 0.0001)
(EXPECT #7022 = 99.9 WITHIN 0.0001)
(EXPECT NO WARNING PRB304)

(CASE without the setting the program says so)
(SET #20010 = 1)
%
O02001
IF [ #20010 EQ 1 ] #3000= 10 (SETTING 10)
M30
%
(EXPECT ALARM 1010 AT 4)
(EXPECT MESSAGE "SETTING 10")
