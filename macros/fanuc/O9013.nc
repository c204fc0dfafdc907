%
O9013 (G120 CIRCLE THROUGH THREE POINTS)
(CALL  G120 A_ H_ C_ W_)
(A #1   THREE ROWS OF BUFFER A, 123)
(H #11  PLANE  0 X-Y  1 Y-Z  2 Z-X)
(C #3   ROW 1 TO 5 OF BUFFER C)
(W #23  NOT 0 MEANS NO PRINT)
(BUFFER C  X #105.., Y #120.., Z #135.., DIAMETER #150..)
(THE COORDINATE ACROSS THE PLANE IS 0)
IF [#1 EQ #0] THEN #1= 123
IF [#3 EQ #0] THEN #3= 1
IF [#11 EQ #0] THEN #11= 0
IF [#1 NE ROUND[#1]] GOTO 92
IF [#1 LT 111] GOTO 92
IF [#1 GT 999] GOTO 92
IF [#3 NE ROUND[#3]] GOTO 92
IF [#3 LT 1] GOTO 92
IF [#3 GT 5] GOTO 92
IF [#11 NE ROUND[#11]] GOTO 92
IF [#11 LT 0] GOTO 92
IF [#11 GT 2] GOTO 92
#8= 159+15*#11 (COLUMNS OF THE TWO AXES OF THE PLANE, BEFORE ROW 1)
#9= 174+15*#11
IF [#11 EQ 2] THEN #9= 159
#5= #1
#6= 100
#7= 24
(POINTS TO #24 #25, #26 #27, #28 #29)
WHILE [#7 LT 29] DO1
#10= FIX[[#5+.5]/#6]
#5= #5-#10*#6
#6= #6/10
IF [#10 EQ 0] GOTO 92
IF [#[#8+#10] EQ #0] GOTO 93
IF [#[#9+#10] EQ #0] GOTO 93
#[#7]= #[#8+#10]
#[#7+1]= #[#9+#10]
#7= #7+2
END1
#12= #26-#24 (FROM POINT 1 TO 2 AND TO 3)
#13= #27-#25
#14= #28-#24
#15= #29-#25
(WHAT IS ONLY NOISE BECOMES 0, ITS SQUARE WOULD BE ALARM 111)
#10= 12
WHILE [#10 LE 15] DO1
IF [ABS[#[#10]] LT .00000001] THEN #[#10]= 0
#10= #10+1
END1
#16= #12*#12+#13*#13
#17= #14*#14+#15*#15
#18= #12*#15-#13*#14
(LONGEST SIDE OF THE TRIANGLE, SQUARED)
#19= #16+#17-2*[#12*#14+#13*#15]
IF [#16 GT #19] THEN #19= #16
IF [#17 GT #19] THEN #19= #17
IF [ABS[#18] LE #19/10000] GOTO 94
(CENTRE FROM POINT 1)
#20= [#16*#15-#17*#13]/[2*#18]
#21= [#17*#12-#16*#14]/[2*#18]
#10= 20
WHILE [#10 LE 21] DO1
IF [ABS[#[#10]] LT .00000001] THEN #[#10]= 0
#10= #10+1
END1
#22= 2*SQRT[#20*#20+#21*#21]
#20= #24+#20
#21= #25+#21
#10= #11+1
IF [#10 EQ 3] THEN #10= 0
#24= 0
#25= 0
#26= 0
#[24+#11]= #20
#[24+#10]= #21
#[104+#3]= #24
#[119+#3]= #25
#[134+#3]= #26
#[149+#3]= #22
IF [ABS[#23] GT 0] GOTO 9
POPEN
DPRNT[+*****-----*G120*SOKUTEI*-----*****+]
DPRNT[+**********************************+]
DPRNT[+*CIRCLE*CENTER*POINT*NO.#3[10]********+]
DPRNT[+**********************************+]
IF [#11 EQ 1] GOTO 1
IF [#11 EQ 2] GOTO 2
DPRNT[+*X-Y*PLANE*ABS.*DATA**************+]
DPRNT[+*X#24[43]*Y#25[43]************+]
GOTO 3
N1 DPRNT[+*Y-Z*PLANE*ABS.*DATA**************+]
DPRNT[+*Y#25[43]*Z#26[43]************+]
GOTO 3
N2 DPRNT[+*Z-X*PLANE*ABS.*DATA**************+]
DPRNT[+*Z#26[43]*X#24[43]************+]
N3 DPRNT[+**********************************+]
DPRNT[+*/DIAMETER************************+]
DPRNT[+*DIA.#22[43]********************+]
DPRNT[+**********************************+]
DPRNT[+*********-----*END*-----**********+]
PCLOS
N9 M99
N92 #3000= 182 (DATA OVER)
N93 #3000= 160 (ROW EMPTY)
N94 #3000= 165 (POINTS ON ONE LINE)
%
